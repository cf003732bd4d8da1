#include "io/files/output_target.h"

#include <unistd.h>

#include <charconv>
#include <string>

#include "io/files/error.h"

namespace sturm {

namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;  // as many as the kernel follows

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw RuntimeFailure(path.string() + ": cannot be written: " + reason);
}

/// The number of one of this process's open files, if `path` is its name in /proc; such a link cannot be followed by
/// reading it.
int descriptor_of(const fs::path& path) {
  std::error_code code;
  const fs::path folder = fs::canonical(path.has_parent_path() ? path.parent_path() : ".", code);
  const std::string process = "/proc/" + std::to_string(::getpid());
  if (code || (folder != process + "/fd" && !folder.string().starts_with(process + "/task/"))) return -1;
  const std::string name = path.filename().string();
  int number = -1;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  return error == std::errc() && end == name.data() + name.size() ? number : -1;
}

OutputTarget::Kind kind_of(const fs::path& path, const fs::file_status& status) {
  switch (status.type()) {
    case fs::file_type::not_found:
    case fs::file_type::regular:
      return OutputTarget::Kind::File;
    case fs::file_type::fifo:
    case fs::file_type::character:
      return OutputTarget::Kind::Node;
    case fs::file_type::directory:
      refuse(path, "it is a folder");
    case fs::file_type::block:
      refuse(path, "it is a block device");
    case fs::file_type::socket:
      refuse(path, "it is a socket");
    default:
      refuse(path, "it is no file");
  }
}

}  // namespace

OutputTarget output_target(const fs::path& path) {
  fs::path at = path;
  for (int links = 0; links <= most_links; ++links) {
    std::error_code code;
    if (!fs::is_symlink(fs::symlink_status(at, code))) {
      const fs::file_status status = fs::status(at, code);
      if (code && status.type() != fs::file_type::not_found) refuse(path, code.message());
      return {kind_of(path, status), at, -1};
    }
    if (const int descriptor = descriptor_of(at); descriptor >= 0)
      return {OutputTarget::Kind::Descriptor, {}, descriptor};
    const fs::path to = fs::read_symlink(at, code);
    if (code) refuse(path, code.message());
    at = to.is_absolute() ? to : at.parent_path() / to;
  }
  refuse(path, "its symbolic links lead in a circle");
}

}  // namespace sturm
