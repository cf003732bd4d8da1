#include "io/files/atomic_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>
#include <utility>

#include "io/files/error.h"

namespace sturm {

namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 18;
constexpr std::size_t longest_stem = 200;  // of the 255 bytes that a name may have

/// Writes all of `bytes`; returns 0 or what errno says.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

bool is_file(const OutputTarget& target) {
  return target.kind == OutputTarget::Kind::File;
}

/// Whether something may be written to a FIFO, a device or an open file, without opening it: a reader of a FIFO would
/// take that for the whole of its input.
bool takes_bytes(const OutputTarget& target) {
  if (target.kind == OutputTarget::Kind::Node) return ::access(target.file.c_str(), W_OK) == 0;
  const int flags = ::fcntl(target.descriptor, F_GETFL);
  if (flags >= 0 && (flags & O_ACCMODE) == O_RDONLY) errno = EBADF;
  return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)), target_(output_target(path_)) {
  if (is_file(target_)) {
    create_temporary();
    return;
  }
  if (!takes_bytes(target_)) throw RuntimeFailure(path_.string() + ": cannot be written: " + std::strerror(errno));
  file_ = ::memfd_create("sturm", MFD_CLOEXEC);
  if (file_ < 0) throw RuntimeFailure(path_.string() + ": no memory for its bytes: " + std::strerror(errno));
}

void AtomicFile::create_temporary() {
  const std::string stem =
      "." + target_.file.filename().string().substr(0, longest_stem) + ".tmp-" + std::to_string(::getpid()) + "-";
  for (int attempt = 0; attempt < 1000; ++attempt) {
    temporary_ = target_.file.parent_path() / (stem + std::to_string(attempt));
    file_ = ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file_ >= 0) break;
    if (errno != EEXIST) break;
  }
  if (file_ < 0) {
    temporary_.clear();
    throw RuntimeFailure(path_.string() + ": cannot be created: " + std::strerror(errno));
  }
  struct stat replaced {};
  if (::stat(target_.file.c_str(), &replaced) == 0) ::fchmod(file_, replaced.st_mode & 0777);
}

AtomicFile::~AtomicFile() {
  if (file_ >= 0) ::close(file_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

bool AtomicFile::is_temporary(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  const std::size_t at = name.rfind(".tmp-");
  return name.starts_with('.') && at != std::string::npos && at > 0 &&
         name.find_first_not_of("0123456789-", at + 5) == std::string::npos;
}

void AtomicFile::fail(int error) {
  error_ = error;
  throw RuntimeFailure(path_.string() + ": writing failed: " + std::strerror(error));
}

void AtomicFile::write_buffer() {
  if (error_) fail(error_);
  if (const int error = write_all(file_, std::exchange(buffer_, {}))) fail(error);
}

void AtomicFile::write(std::string_view bytes) {
  if (error_) fail(error_);
  position_ += bytes.size();
  if (buffer_.size() + bytes.size() > buffer_bytes) write_buffer();
  if (bytes.size() < buffer_bytes)
    buffer_ += bytes;
  else if (const int error = write_all(file_, bytes))
    fail(error);
}

void AtomicFile::seek(std::uint64_t position) {
  write_buffer();
  if (::lseek(file_, static_cast<off_t>(position), SEEK_SET) < 0) fail(errno);
  position_ = position;
}

void AtomicFile::hand_on() {
  std::fflush(stdout);  // what was printed before comes before
  std::cout.flush();
  const int to = target_.kind == OutputTarget::Kind::Node
                     ? ::open(target_.file.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY)
                     : ::fcntl(target_.descriptor, F_DUPFD_CLOEXEC, 0);
  if (to < 0) fail(errno);
  std::array<char, std::size_t{1} << 16> piece;
  int error = ::lseek(file_, 0, SEEK_SET) < 0 ? errno : 0;
  while (!error) {
    const ssize_t count = ::read(file_, piece.data(), piece.size());
    if (count < 0) error = errno;
    if (count <= 0) break;
    error = write_all(to, {piece.data(), static_cast<std::size_t>(count)});
  }
  if (::close(to) != 0 && !error) error = errno;
  if (error) fail(error);
}

void AtomicFile::commit() {
  write_buffer();
  if (!is_file(target_)) {
    hand_on();
    return;
  }
  if (::close(std::exchange(file_, -1)) != 0) fail(errno);
  if (::rename(temporary_.c_str(), target_.file.c_str()) != 0)
    throw RuntimeFailure(path_.string() + ": cannot be created: " + std::strerror(errno));
  temporary_.clear();
}

void write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace sturm
