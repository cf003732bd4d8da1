#include "io/json/stored.h"

#include <charconv>
#include <cmath>

namespace sturm {

namespace {

const Json none;
const Json empty_array = Json::array();

const Json& step(const Json& json, std::string_view name) {
  if (json.is_object()) {
    const auto found = json.find(std::string(name));
    return found == json.end() ? none : *found;
  }
  std::size_t index = 0;
  const auto parsed = std::from_chars(name.data(), name.data() + name.size(), index);
  const bool whole = parsed.ec == std::errc() && parsed.ptr == name.data() + name.size();
  return json.is_array() && whole && index < json.size() ? json[index] : none;
}

}  // namespace

const Json& value_at(const Json& json, std::string_view path) {
  const Json* value = &json;
  while (!path.empty()) {
    const std::size_t slash = path.find('/');
    value = &step(*value, path.substr(0, slash));
    path = slash == std::string_view::npos ? std::string_view() : path.substr(slash + 1);
  }
  return *value;
}

std::optional<double> number_at(const Json& json, std::string_view path) {
  const Json& value = value_at(json, path);
  if (!value.is_number()) return std::nullopt;
  const double number = value.get<double>();
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::optional<bool> boolean_at(const Json& json, std::string_view path) {
  const Json& value = value_at(json, path);
  return value.is_boolean() ? std::optional(value.get<bool>()) : std::nullopt;
}

std::string text_at(const Json& json, std::string_view path) {
  const Json& value = value_at(json, path);
  return value.is_string() ? value.get<std::string>() : std::string();
}

const Json& array_at(const Json& json, std::string_view path) {
  const Json& value = value_at(json, path);
  return value.is_array() ? value : empty_array;
}

}  // namespace sturm
