#pragma once
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "io/json/stored.h"
#include "io/json/values.h"

namespace sturm {

/// A structure both ways between memory and JSON, from one list of its members. A record's list is written once, beside
/// its reader and writer, which are then the only code that knows its keys:
///
///   template <>
///   inline constexpr auto record_members<Spot> = std::tuple{member("id", &Spot::id), member("z", &Spot::z)};
///
/// Reading is tolerant (io/json/stored.h): whatever is missing, null or of another type leaves the member as it was
/// made, and an optional one empty. Writing gives every member, null where an optional one is empty or a number is not
/// finite.

/// A number of things.
using Count = std::optional<std::int64_t>;

/// A distance [m] that may be infinite; JSON has "inf" for it.
struct StoredDistance {
  double metres = std::numeric_limits<double>::infinity();
  auto operator<=>(const StoredDistance&) const = default;

  bool is_infinite() const { return std::isinf(metres); }
};

/// Its metres; none where it is infinite or unknown.
inline std::optional<double> finite(const std::optional<StoredDistance>& distance) {
  return distance && !distance->is_infinite() ? std::optional(distance->metres) : std::nullopt;
}

enum class IfEmpty { Null, LeftOut };

template <class Record, class Value>
struct RecordMember {
  const char* key;
  Value Record::*value;
  IfEmpty if_empty = IfEmpty::Null;
};

template <class Record, class Value>
constexpr RecordMember<Record, Value> member(const char* key, Value Record::*value, IfEmpty if_empty = IfEmpty::Null) {
  return {key, value, if_empty};
}

struct NoRecord {};
template <class T>
inline constexpr NoRecord record_members{};

template <class T>
concept StoredRecord = !std::same_as<std::remove_cvref_t<decltype(record_members<T>)>, NoRecord>;

/// What has words in documents: `WordOf<T>::word(value)`, and `value(word)`, none for another word.
template <class T>
struct WordOf;

template <class T>
concept StoredWord = requires(T value) {
  WordOf<T>::word(value);
};

template <class T>
struct RecordFormat;

template <class T>
Json json_from(const T& value) {
  return RecordFormat<T>::json(value);
}

/// Leaves `value` alone where `json` is of another type; false then.
template <class T>
bool read_record(const Json& json, T& value) {
  return RecordFormat<T>::read(json, value);
}

/// Of a list, a record or a single value that stands in `json`; empty where there is none.
template <class T>
T record_from(const Json& json) {
  T value{};
  read_record(json, value);
  return value;
}

template <class T>
requires std::same_as<T, bool> || std::same_as<T, std::string>
struct RecordFormat<T> {
  static Json json(const T& value) { return value; }
  static bool read(const Json& json, T& value) {
    const bool fits = std::same_as<T, bool> ? json.is_boolean() : json.is_string();
    if (fits) value = json.get<T>();
    return fits;
  }
};

template <std::floating_point T>
struct RecordFormat<T> {
  static Json json(T value) { return number_or_null(value); }
  static bool read(const Json& json, T& value) {
    const auto number = number_at(json, "");
    if (number) value = *number;
    return number.has_value();
  }
};

template <class T>
requires std::integral<T> &&(!std::same_as<T, bool>)struct RecordFormat<T> {
  static Json json(T value) { return value; }
  static bool read(const Json& json, T& value) {
    const auto number = number_at(json, "");
    if (!number || *number != std::floor(*number) || std::abs(*number) > 9e15) return false;
    value = static_cast<T>(*number);
    return true;
  }
};

template <>
struct RecordFormat<StoredDistance> {
  static Json json(const StoredDistance& distance) { return distance_json(distance.metres); }
  static bool read(const Json& json, StoredDistance& distance) {
    if (json.is_string() && json == "inf") {
      distance = {};
      return true;
    }
    return read_record(json, distance.metres);
  }
};

template <StoredWord T>
struct RecordFormat<T> {
  static Json json(T value) { return std::string(WordOf<T>::word(value)); }
  static bool read(const Json& json, T& value) {
    const auto known = WordOf<T>::value(text_at(json, ""));
    if (known) value = *known;
    return known.has_value();
  }
};

template <class T>
struct RecordFormat<std::optional<T>> {
  static Json json(const std::optional<T>& value) { return value ? json_from(*value) : Json(nullptr); }
  static bool read(const Json& json, std::optional<T>& value) {
    T found{};
    value = read_record(json, found) ? std::optional<T>(std::move(found)) : std::nullopt;
    return true;
  }
};

template <class T>
struct RecordFormat<std::vector<T>> {
  static Json json(const std::vector<T>& list) {
    Json array = Json::array();
    for (const T& value : list) array.push_back(json_from(value));
    return array;
  }
  static bool read(const Json& json, std::vector<T>& list) {
    if (!json.is_array()) return false;
    list.clear();
    for (const Json& element : json) list.push_back(record_from<T>(element));
    return true;
  }
};

template <class T, std::size_t size>
struct RecordFormat<std::array<T, size>> {
  static Json json(const std::array<T, size>& list) {
    Json array = Json::array();
    for (const T& value : list) array.push_back(json_from(value));
    return array;
  }
  static bool read(const Json& json, std::array<T, size>& list) {
    if (!json.is_array()) return false;
    for (std::size_t i = 0; i < size && i < json.size(); ++i) read_record(json[i], list[i]);
    return true;
  }
};

template <class T>
struct RecordFormat<std::map<std::string, T>> {
  static Json json(const std::map<std::string, T>& values) {
    Json object = Json::object();
    for (const auto& [key, value] : values) object[key] = json_from(value);
    return object;
  }
  static bool read(const Json& json, std::map<std::string, T>& values) {
    if (!json.is_object()) return false;
    values.clear();
    for (const auto& [key, value] : json.items()) values[key] = record_from<T>(value);
    return true;
  }
};

template <StoredRecord T>
struct RecordFormat<T> {
  static Json json(const T& record) {
    Json object = Json::object();
    const auto write = [&](const auto& m) {
      Json value = json_from(record.*m.value);
      if (!value.is_null() || m.if_empty == IfEmpty::Null) object[m.key] = std::move(value);
    };
    std::apply([&](const auto&... members) { (write(members), ...); }, record_members<T>);
    return object;
  }
  static bool read(const Json& json, T& record) {
    if (!json.is_object()) return false;
    std::apply([&](const auto&... members) { (read_record(value_at(json, members.key), record.*members.value), ...); },
               record_members<T>);
    return true;
  }
};

}  // namespace sturm
