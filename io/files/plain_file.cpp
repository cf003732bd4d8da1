#include "io/files/plain_file.h"

#include "io/files/error.h"
#include "io/files/lower_case.h"

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
  return lower_case(path.extension().string()) == lower_case(suffix);
}

}  // namespace sturm
