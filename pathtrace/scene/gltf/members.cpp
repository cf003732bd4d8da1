#include "pathtrace/scene/gltf/members.h"

#include <cmath>

namespace sturm::gltf {

namespace {

constexpr double largest_whole = 9007199254740992.0;  // 2^53, up to which doubles count without gaps

std::optional<std::uint64_t> whole(const Json& value) {
  if (value.is_number_unsigned()) return value.get<std::uint64_t>();
  if (!value.is_number_float()) return std::nullopt;
  const double number = value.get<double>();
  if (!(number >= 0.0 && number <= largest_whole && number == std::floor(number))) return std::nullopt;
  return static_cast<std::uint64_t>(number);
}

}  // namespace

const Json& list(const Json& object, const char* key, const Source& where) {
  static const Json nothing = Json::array();
  const auto at = object.find(key);
  if (at == object.end()) return nothing;
  if (!at->is_array()) (where / key).fail(*at, "a list");
  return *at;
}

const Json& object(const Json& parent, const char* key, const Source& where) {
  static const Json nothing = Json::object();
  const auto at = parent.find(key);
  if (at == parent.end()) return nothing;
  if (!at->is_object()) (where / key).fail(*at, "an object");
  return *at;
}

const Json* extension(const Json& parent, const char* name) {
  const auto all = parent.find("extensions");
  if (all == parent.end() || !all->is_object()) return nullptr;
  const auto at = all->find(name);
  return at == all->end() || !at->is_object() ? nullptr : &*at;
}

std::uint64_t number(const Json& object, const char* key, const Source& where, std::optional<std::uint64_t> otherwise) {
  const auto at = object.is_object() ? object.find(key) : object.end();
  if (!object.is_object() || (at == object.end() && !otherwise))
    where.fail(object, std::string("an object with \"") + key + "\"");
  if (at == object.end()) return *otherwise;
  const std::optional<std::uint64_t> value = whole(*at);
  if (!value) (where / key).fail(*at, "a whole number of at least 0");
  return *value;
}

std::optional<std::size_t> index(const Json& object, const char* key, const Source& where, std::size_t count,
                                 const char* what) {
  const auto at = object.find(key);
  if (at == object.end()) return std::nullopt;
  const std::optional<std::uint64_t> value = whole(*at);
  if (!value || *value >= count)
    (where / key).fail(*at, std::string("the number of a ") + what + ", less than " + std::to_string(count));
  return static_cast<std::size_t>(*value);
}

double real(const Json& object, const char* key, const Source& where, double otherwise) {
  const auto at = object.find(key);
  if (at == object.end()) return otherwise;
  if (!at->is_number()) (where / key).fail(*at, "a number");
  return at->get<double>();
}

std::vector<double> reals(const Json& object, const char* key, const Source& where,
                          const std::vector<double>& otherwise) {
  const auto at = object.find(key);
  if (at == object.end()) return otherwise;
  std::vector<double> values;
  if (at->is_array())
    for (const Json& value : *at)
      if (value.is_number()) values.push_back(value.get<double>());
  if (values.size() != otherwise.size() || at->size() != otherwise.size())
    (where / key).fail(*at, "a list of " + std::to_string(otherwise.size()) + " numbers");
  return values;
}

bool flag(const Json& object, const char* key, const Source& where, bool otherwise) {
  const auto at = object.find(key);
  if (at == object.end()) return otherwise;
  if (!at->is_boolean()) (where / key).fail(*at, "true or false");
  return at->get<bool>();
}

std::string text(const Json& object, const char* key, const Source& where, const std::string& otherwise) {
  const auto at = object.find(key);
  if (at == object.end()) return otherwise;
  if (!at->is_string()) (where / key).fail(*at, "a text");
  return at->get<std::string>();
}

}  // namespace sturm::gltf
