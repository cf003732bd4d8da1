#include "io/files/sandbox.h"

#include <algorithm>

namespace sturm {

namespace {

namespace fs = std::filesystem;

bool in_sandbox = false;

/// With links followed as far as the path exists.
fs::path followed(const fs::path& path) {
  std::error_code code;
  fs::path result = fs::weakly_canonical(fs::absolute(path), code);
  return code ? fs::path() : result;
}

}  // namespace

void enter_sandbox() {
  in_sandbox = true;
}

bool sandbox_is_on() {
  return in_sandbox;
}

bool within_sandbox(const fs::path& path, const std::string& naming_file) {
  if (!in_sandbox || naming_file == command_line_source) return true;
  const fs::path folder =
      followed(naming_file == "<stdin>" ? fs::current_path() : fs::absolute(naming_file).parent_path());
  const fs::path target = followed(path);
  if (folder.empty() || target.empty()) return false;
  return std::mismatch(folder.begin(), folder.end(), target.begin(), target.end()).first == folder.end();
}

}  // namespace sturm
