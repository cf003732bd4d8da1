#include "io/files/plain_file.h"

#include <algorithm>

#include "io/files/error.h"

namespace sturm {

void require_plain_file(const std::filesystem::path& path, const std::string& expected) {
  std::error_code code;
  const std::filesystem::file_status status = std::filesystem::status(path, code);
  if (std::filesystem::is_regular_file(status)) return;
  const char* what = std::filesystem::is_directory(status) ? "a folder"
                     : std::filesystem::exists(status)     ? "a pipe or device"
                                                           : "no such file";
  throw InputError(path.string(), "", what, expected);
}

bool has_suffix(const std::filesystem::path& path, const std::string& suffix) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  const std::string own = path.extension().string();
  return std::equal(own.begin(), own.end(), suffix.begin(), suffix.end(),
                    [&](char a, char b) { return lower(a) == lower(b); });
}

}  // namespace sturm
