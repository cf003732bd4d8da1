#include "io/json/named_file.h"

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "io/files/error.h"
#include "io/files/shipped_files.h"
#include "io/json/schema.h"
#include "io/json/suggest.h"

namespace sturm {

namespace {

namespace fs = std::filesystem;

/// Formats of documents that are shipped, and their folders.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> folders_of_formats{
    {{"render", "views"},
     {"scene", "scenes"},
     {"spectacles", "lenses"},
     {"eye", "eyes"},
     {"experiment", "experiments"},
     {"gates", "gates"},
     {"bench", "benchmarks"},
     {"blurfield", "blurfields"}}};

bool is_file(const fs::path& path) {
  std::error_code code;
  return fs::is_regular_file(path, code);
}

[[noreturn]] void fail_missing(const Json& value, const Source& where, const std::string& what, const fs::path& path,
                               const std::string& names = "") {
  where.fail(value, what + "; there is no file " + path.string() + names);
}

/// The nearest name, or all of them where none is near.
std::string meant_or_known(const std::string& name, const std::vector<std::string>& known) {
  const std::string near = did_you_mean(name, known);
  return near.empty() ? " (" + one_of(known) + ")" : near;
}

}  // namespace

std::string shipped_kind(std::string_view schema_name) {
  for (const auto& [schema, folder] : folders_of_formats)
    if (schema == schema_name) return std::string(folder);
  return "";
}

std::vector<std::string> shipped_kinds() {
  std::vector<std::string> kinds;
  for (const auto& [schema, folder] : folders_of_formats) kinds.emplace_back(folder);
  return kinds;
}

fs::path existing_file(const Json& value, const Source& where, const char* what) {
  const std::string name = value.get<std::string>();
  const fs::path path = path_beside(name, where.file);
  if (is_file(path)) return path;
  if (const auto shipped = shipped_counterpart(name)) return *shipped;
  fail_missing(value, where, what, path);
}

fs::path existing_document(const Json& value, const Source& where, const char* schema_name, const char* what) {
  const std::string name = value.get<std::string>();
  const fs::path path = path_beside(name, where.file);
  if (is_file(path)) return path;
  const std::string kind = shipped_kind(schema_name);
  if (const auto shipped = shipped_document(kind, name)) return *shipped;
  if (const auto shipped = shipped_counterpart(name)) return *shipped;
  const std::vector<std::string> known = kind.empty() ? std::vector<std::string>() : shipped_names(kind);
  fail_missing(value, where, what, path,
               known.empty() ? "" : ", nor is it the name of a shipped one" + meant_or_known(name, known));
}

fs::path named_document_file(const Json& value, const Source& where, const char* schema_name) {
  const std::string what = std::string("the path of a sturm.") + schema_name + "/1 file";
  return existing_document(value, where, schema_name, what.c_str());
}

Json load_named_document(const Json& value, const Source& where, const char* schema_name) {
  const std::string file = named_document_file(value, where, schema_name).string();
  Json document = load_json(file);
  if (!document.is_object())
    Source{file, ""}.fail(document, std::string("an object of format sturm.") + schema_name + "/1");
  validate(document, schema_name, file);
  return document;
}

}  // namespace sturm
