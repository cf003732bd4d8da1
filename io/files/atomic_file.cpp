#include "io/files/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "io/files/error.h"

namespace sturm {

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)) {
  std::string stem(1, '.');
  stem += path_.filename().string() + ".tmp-" + std::to_string(::getpid()) + "-";
  for (int attempt = 0; attempt < 1000; ++attempt) {
    temporary_ = path_.parent_path() / (stem + std::to_string(attempt));
    const int file = ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file >= 0) {
      ::close(file);
      return;
    }
    if (errno != EEXIST) break;
  }
  throw RuntimeFailure(path_.string() + ": cannot be created: " + std::strerror(errno));
}

AtomicFile::~AtomicFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

bool AtomicFile::is_temporary(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const std::size_t at = name.rfind(".tmp-");
  return name.starts_with('.') && at != std::string::npos && at > 0 &&
         name.find_first_not_of("0123456789-", at + 5) == std::string::npos;
}

void AtomicFile::commit() {
  std::error_code code;
  std::filesystem::rename(temporary_, path_, code);
  if (code) throw RuntimeFailure(path_.string() + ": cannot be created: " + code.message());
  temporary_.clear();
}

void write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  AtomicFile file(path);
  std::ofstream stream(file.temporary(), std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) throw RuntimeFailure(path.string() + ": writing failed: " + std::strerror(errno));
  file.commit();
}

}  // namespace sturm
