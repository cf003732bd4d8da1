#pragma once
// Used by the EXR writers only: it brings OpenEXR's headers with it.
#include <OpenEXR/ImfIO.h>

#include <exception>
#include <filesystem>

#include "io/files/atomic_file.h"
#include "io/files/error.h"

namespace sturm {

/// Lets OpenEXR write into an AtomicFile, whose `commit` tells of failures that OpenEXR's destructors keep to
/// themselves.
class ExrOutput : public Imf::OStream {
 public:
  explicit ExrOutput(AtomicFile& file) : Imf::OStream("output"), file_(file) {}

  void write(const char bytes[], int count) override { file_.write({bytes, static_cast<std::size_t>(count)}); }
  std::uint64_t tellp() override { return file_.position(); }
  void seekp(std::uint64_t position) override { file_.seek(position); }

 private:
  AtomicFile& file_;
};

/// Writes one EXR: `write` is given the stream. What goes wrong becomes a RuntimeFailure, and no file is left.
template <class Write>
void write_exr_file(const std::filesystem::path& path, const Write& write) {
  AtomicFile file(path);
  try {
    ExrOutput output(file);
    write(output);
  } catch (const RuntimeFailure&) {  // the file's own
    throw;
  } catch (const std::exception& error) {
    throw RuntimeFailure(path.string() + ": writing failed: " + error.what());
  }
  file.commit();
}

}  // namespace sturm
