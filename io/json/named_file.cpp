#include "io/json/named_file.h"

#include <nlohmann/json.hpp>
#include <string>

#include "io/files/error.h"
#include "io/json/schema.h"

namespace sturm {

std::filesystem::path existing_file(const Json& value, const Source& where, const char* what) {
  const std::filesystem::path path = path_beside(value.get<std::string>(), where.file);
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code))
    where.fail(value, std::string(what) + "; there is no file " + path.string());
  return path;
}

Json load_named_document(const Json& value, const Source& where, const char* schema_name) {
  const std::string what = std::string("the path of a sturm.") + schema_name + "/1 file";
  const std::string file = existing_file(value, where, what.c_str()).string();
  Json document = load_json(file);
  if (!document.is_object())
    Source{file, ""}.fail(document, std::string("an object of format sturm.") + schema_name + "/1");
  validate(document, schema_name, file);
  return document;
}

}  // namespace sturm
