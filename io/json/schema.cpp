#include "io/json/schema.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "io/files/error.h"
#include "io/json/schema_expectation.h"
#include "io/json/schema_violation.h"
#include "io/json/suggest.h"

namespace sturm {

namespace {

constexpr std::string_view suffix = ".schema.json";

/// Hoists everything that a schema takes from other files into its own definitions.
class Hoister {
 public:
  explicit Hoister(const std::string& root) : root_(root) {}

  Json run() {
    Json document = load(root_);
    rewrite(document, root_);
    for (auto& [name, definition] : hoisted_.items()) {
      Json& place = document["definitions"][name];
      if (!place.is_null() && place != definition)
        throw std::logic_error("schema " + root_ + ": two definitions of " + name);
      place = std::move(definition);
    }
    return document;
  }

 private:
  static Json load(const std::string& name) {
    for (const auto& [file, text] : embedded_schemas())
      if (file == name + std::string(suffix)) return Json::parse(text);
    throw InputError("", "", "\"" + name + "\"" + did_you_mean(name, schema_names()), one_of(schema_names()));
  }

  void rewrite(Json& node, const std::string& file) {
    if (node.is_object()) {
      const auto ref = node.find("$ref");
      if (ref != node.end() && ref->is_string()) *ref = hoist(ref->get<std::string>(), file);
    }
    if (node.is_structured())
      for (Json& child : node) rewrite(child, file);
  }

  /// What `ref`, written in the schema `file`, is called in the root document.
  std::string hoist(const std::string& ref, const std::string& file) {
    const std::size_t hash = std::min(ref.find('#'), ref.size());
    const std::string target_file = hash == 0 ? file : ref.substr(0, hash - suffix.size());
    const std::string fragment = ref.substr(std::min(hash + 1, ref.size()));
    if (target_file == root_) return "#" + fragment;
    const std::string name = fragment.empty() ? target_file : fragment.substr(fragment.rfind('/') + 1);
    const std::string place = "#/definitions/" + name;
    if (!origins_.insert(target_file + "#" + fragment).second) return place;
    Json definition = load(target_file).at(Json::json_pointer(fragment));
    if (fragment.empty())
      for (const char* key : {"definitions", "$schema"}) definition.erase(key);
    rewrite(definition, target_file);
    if (hoisted_.contains(name) && hoisted_[name] != definition)
      throw std::logic_error("schema " + root_ + ": two definitions of " + name);
    hoisted_[name] = std::move(definition);
    return place;
  }

  std::string root_;
  Json hoisted_ = Json::object();
  std::set<std::string> origins_;
};

/// Throws for a key that breaks the pattern which its object's schema has for names.
void refuse_wrong_name(const std::string& key, const Json& rules, const Source& where) {
  const auto names = rules.find("propertyNames");
  if (names == rules.end() || !names->contains("pattern")) return;
  const std::regex pattern((*names)["pattern"].get<std::string>());
  if (std::regex_search(key, pattern)) return;
  // "Z4", "c4" and "04" stand for 4.
  const std::string digits = key.substr(std::min(key.find_first_of("123456789"), key.size()));
  const std::string hint = std::regex_search(digits, pattern) ? " (did you mean \"" + digits + "\"?)" : "";
  const Source place = where / key;
  throw InputError(place.file, place.pointer, "the key " + compact(Json(key)) + hint,
                   names->value("description", "a key like " + (*names)["pattern"].get<std::string>()));
}

void refuse_unknown_keys(const Json& value, const Json& node, const Json& schema, const Source& where) {
  const Json& here = dereferenced(node, schema);
  if (value.is_object()) {
    for (const auto& [key, member] : value.items()) {
      refuse_wrong_name(key, here, where);
      const Json* child = child_schema(here, key, true);
      if (!child && here.value("additionalProperties", Json(true)) == Json(false)) {
        std::vector<std::string> known;
        const Json properties = here.value("properties", Json::object());
        for (const auto& [name, unused] : properties.items()) known.push_back(name);
        const Source place = where / key;
        throw InputError(place.file, place.pointer, "an unknown key" + did_you_mean(key, known), one_of(known));
      }
      if (child) refuse_unknown_keys(member, *child, schema, where / key);
    }
  } else if (value.is_array()) {
    if (const Json* child = child_schema(here, "0", false))
      for (std::size_t i = 0; i < value.size(); ++i)
        if (value[i].is_structured()) refuse_unknown_keys(value[i], *child, schema, where / i);
  }
}

void fill_defaults(Json& value, const Json& node, const Json& schema) {
  const Json& here = dereferenced(node, schema);
  if (value.is_object()) {
    if (const auto properties = here.find("properties"); properties != here.end())
      for (const auto& [key, property] : properties->items()) {
        const Json& rules = dereferenced(property, schema);
        if (!value.contains(key) && rules.contains("default")) value[key] = rules["default"];
      }
    for (const auto& [key, member] : value.items())
      if (const Json* child = child_schema(here, key, true)) fill_defaults(member, *child, schema);
  } else if (value.is_array()) {
    if (const Json* child = child_schema(here, "0", false))
      for (Json& element : value) fill_defaults(element, *child, schema);
  }
}

}  // namespace

std::vector<std::string> schema_names() {
  std::vector<std::string> names;
  for (const auto& [file, text] : embedded_schemas()) names.emplace_back(file.substr(0, file.size() - suffix.size()));
  std::sort(names.begin(), names.end());
  return names;
}

Json schema_document(std::string_view name) {
  return Hoister(std::string(name)).run();
}

std::string schema_text(std::string_view name) {
  return schema_document(name).dump(2) + "\n";
}

std::string format_of(const Json& document, const std::string& file) {
  const Source root{file, ""};
  if (!document.is_object()) root.fail(document, "an object with a \"format\"");
  std::vector<std::string> known;
  const std::vector<std::string> names = schema_names();
  for (const std::string& name : names) known.push_back("sturm." + name + "/1");
  const auto format = document.find("format");
  if (format == document.end()) throw InputError(file, "", "no \"format\"", "\"format\": " + one_of(known));
  if (format->is_string())
    if (const auto at = std::find(known.begin(), known.end(), format->get<std::string>()); at != known.end())
      return names[static_cast<std::size_t>(at - known.begin())];
  throw InputError(file, "/format",
                   compact(*format) + (format->is_string() ? did_you_mean(format->get<std::string>(), known) : ""),
                   one_of(known));
}

void validate(const Json& document, std::string_view schema_name, const std::string& file) {
  validate(document, schema_name, Source{file, ""});
}

void validate(const Json& document, std::string_view schema_name, const Source& root) {
  const Json schema = schema_document(schema_name);
  refuse_unknown_keys(document, schema, schema, root);
  const auto violation = first_violation(document, schema);
  if (!violation) return;

  const Json* value = &document;
  const Json* node = &dereferenced(schema, schema);
  Source where = root;
  for (const std::string& token : violation->path) {
    const bool object = value->is_object();
    const Json* child = child_schema(*node, token, object);
    if (!child) break;  // the schema says no more about this place
    value = object ? &(*value)[token] : &(*value)[std::stoul(token)];
    node = &dereferenced(*child, schema);
    where = where / token;
  }
  if (!violation->missing.empty()) {
    const Json* child = child_schema(*node, violation->missing, true);
    throw InputError(
        where.file, where.pointer, "no \"" + violation->missing + "\"",
        "\"" + violation->missing + "\": " + (child ? expectation(dereferenced(*child, schema)) : "a value"));
  }
  std::string hint;
  if (value->is_string() && node->contains("enum"))
    hint = did_you_mean(value->get<std::string>(), (*node)["enum"].get<std::vector<std::string>>());
  throw InputError(where.file, where.pointer, compact(*value) + hint, expectation(*node));
}

Json with_defaults(const Json& document, std::string_view schema_name) {
  const Json schema = schema_document(schema_name);
  Json filled = document;
  fill_defaults(filled, schema, schema);
  return filled;
}

Json with_defaults(const Json& value, std::string_view schema_name, const std::string& definition) {
  const Json schema = schema_document(schema_name);
  Json filled = value;
  fill_defaults(filled, schema.at("definitions").at(definition), schema);
  return filled;
}

}  // namespace sturm
