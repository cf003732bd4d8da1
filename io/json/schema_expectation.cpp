#include "io/json/schema_expectation.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "io/json/suggest.h"

namespace sturm {

namespace {

std::string number_range(const Json& node) {
  const bool low = node.contains("minimum"), high = node.contains("maximum");
  if (low && high) return " from " + node["minimum"].dump() + " to " + node["maximum"].dump();
  std::string text;
  const auto add = [&](const char* keyword, const char* sign) {
    if (node.contains(keyword)) text += (text.empty() ? " " : " and ") + std::string(sign) + " " + node[keyword].dump();
  };
  add("minimum", "≥");
  add("exclusiveMinimum", ">");
  add("maximum", "≤");
  add("exclusiveMaximum", "<");
  return text;
}

std::string array_size(const Json& node) {
  const auto items = [](const Json& count) { return count.dump() + (count == 1 ? " item" : " items"); };
  const bool low = node.contains("minItems"), high = node.contains("maxItems");
  std::string text;
  if (low && high && node["minItems"] == node["maxItems"])
    text = " of " + items(node["minItems"]);
  else if (low && high)
    text = " of " + node["minItems"].dump() + " to " + items(node["maxItems"]);
  else if (low)
    text = " of at least " + items(node["minItems"]);
  if (node.value("uniqueItems", false)) text += ", no two alike";
  return text;
}

std::string in_words(const std::string& type, const Json& node) {
  if (type == "number") return "a number" + number_range(node);
  if (type == "integer") return "an integer" + number_range(node);
  if (type == "array") return "an array" + array_size(node);
  if (type == "object") return "an object";
  if (type == "boolean") return "true or false";
  if (type == "null") return "null";
  const std::string pattern = node.value("pattern", "");
  if (pattern == "^inf$") return "\"inf\"";
  if (!pattern.empty()) return "a string like " + pattern;
  return node.contains("minLength") ? "a string that is not empty" : "a string";
}

}  // namespace

const Json& dereferenced(const Json& node, const Json& schema) {
  const Json* at = &node;
  while (at->is_object() && at->contains("$ref"))
    at = &schema.at(Json::json_pointer((*at)["$ref"].get<std::string>().substr(1)));
  return *at;
}

const Json* child_schema(const Json& node, std::string_view token, bool object) {
  const auto find = [](const Json& parent, const std::string& key) -> const Json* {
    const auto at = parent.find(key);
    return at != parent.end() && at->is_object() ? &*at : nullptr;
  };
  if (!object) return find(node, "items");
  if (const Json* properties = find(node, "properties"))
    if (const Json* property = find(*properties, std::string(token))) return property;
  return find(node, "additionalProperties");
}

std::string expectation(const Json& node) {
  std::string text;
  if (node.contains("const")) {
    text = node["const"].dump();
  } else if (node.contains("enum")) {
    text = one_of(node["enum"].get<std::vector<std::string>>());
  } else if (node.contains("type")) {
    const Json& type = node["type"];
    if (type.is_string())
      text = in_words(type.get<std::string>(), node);
    else
      for (const Json& choice : type) text += (text.empty() ? "" : " or ") + in_words(choice.get<std::string>(), node);
  }
  const std::string description = node.value("description", "");
  if (text.empty()) return description;
  return description.empty() ? text : text + " (" + description + ")";
}

}  // namespace sturm
