#pragma once
#include <filesystem>
#include <string_view>

namespace sturm {

/// A file that appears under its name complete or not at all: write to `temporary()`, then `commit()`. Without commit
/// the temporary file disappears. Safe against the death of the process, not of the machine (nothing is synced to the
/// disk).
class AtomicFile {
 public:
  /// Creates the temporary file in the folder of `path`. Throws RuntimeFailure.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::filesystem::path& temporary() const { return temporary_; }

  /// Whether a name is one that this class gives: what a killed process left behind.
  static bool is_temporary(const std::filesystem::path& path);

  /// Renames the temporary file to its final name, replacing what was there. Throws RuntimeFailure.
  void commit();

 private:
  std::filesystem::path path_, temporary_;
};

/// Writes `bytes` to `path` through an AtomicFile. Throws RuntimeFailure.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace sturm
