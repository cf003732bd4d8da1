#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "io/files/output_target.h"

namespace sturm {

/// A file that appears under its name complete or not at all: `write`, then `commit`. Without commit nothing appears
/// and the temporary file beside it is gone. Every byte is checked, the last one when the file is closed. Safe against
/// the death of the process, not of the machine (nothing is synced to the disk).
///
/// A symbolic link stays one: what it points to is replaced, or made. A FIFO or a device is never replaced: the bytes
/// are collected in memory and written to it by `commit`.
class AtomicFile {
 public:
  /// Creates the temporary file in the folder of what is to be replaced; a replaced file hands down its permissions.
  /// Throws RuntimeFailure.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Empty where the bytes are collected for a FIFO or device.
  const std::filesystem::path& temporary() const { return temporary_; }

  /// Whether a name is one that this class gives: what a killed process left behind.
  static bool is_temporary(const std::filesystem::path& path);

  /// Writes behind what was written last, or at the position that was sought. Throws RuntimeFailure; from then on
  /// `commit` does, too.
  void write(std::string_view bytes);
  void seek(std::uint64_t position);
  std::uint64_t position() const { return position_; }

  /// Closes the temporary file and renames it to its final name, or hands the bytes on. Throws RuntimeFailure where any
  /// byte could not be written.
  void commit();

 private:
  void create_temporary();
  void write_buffer();
  void hand_on();
  [[noreturn]] void fail(int error);

  std::filesystem::path path_, temporary_;
  OutputTarget target_;
  int file_ = -1, error_ = 0;  // an error of errno that has been met
  std::uint64_t position_ = 0;
  std::string buffer_;  // its bytes end at `position_`
};

/// Writes `bytes` to `path` through an AtomicFile. Throws RuntimeFailure.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace sturm
