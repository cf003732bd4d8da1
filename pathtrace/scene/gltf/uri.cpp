#include "pathtrace/scene/gltf/uri.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/files/lower_case.h"
#include "io/files/sandbox.h"
#include "io/json/data_uri.h"

namespace sturm::gltf {

namespace {

bool starts_with_word(std::string_view text, std::string_view word) {
  return lower_case(text.substr(0, word.size())) == word;
}

}  // namespace

std::filesystem::path file_of_uri(const std::string& uri, const std::filesystem::path& naming_file,
                                  const Source& where) {
  if (uri.find("://") != std::string::npos && !starts_with_word(uri, "file://"))
    where.fail(uri, "a data URI, or the name of a file beside the model");
  std::string name = starts_with_word(uri, "file://") ? uri.substr(7) : uri;
  std::string slashes = name;
  std::replace(slashes.begin(), slashes.end(), '\\', '/');  // written on Windows
  std::string fallback;
  for (const std::string& written : {percent_decoded(name), name, percent_decoded(slashes), slashes}) {
    const std::filesystem::path file = naming_file.parent_path() / written;
    if (!within_sandbox(file, naming_file.string()))
      throw InputError(where.file, where.pointer, written,
                       "with --sandbox a file in the folder of the model, or below");
    std::error_code code;
    if (std::filesystem::is_regular_file(file, code)) return file;
    if (fallback.empty()) fallback = file.string();
  }
  throw InputError(where.file, where.pointer, fallback, "a file that exists");
}

}  // namespace sturm::gltf
