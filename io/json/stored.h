#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "io/json/json.h"

namespace sturm {

/// Reading a stored report without trusting it: whatever is missing, null or of another type is absent.
/// A path is a row of member names or array indices, "verdict/passed" or "semi_axes_rad/0"; "" is the value itself.

/// The value at `path`, or a JSON null.
const Json& value_at(const Json& json, std::string_view path);

/// A finite number.
std::optional<double> number_at(const Json& json, std::string_view path);

std::optional<bool> boolean_at(const Json& json, std::string_view path);

/// A string, or "" where there is none.
std::string text_at(const Json& json, std::string_view path);

/// An array, or an empty one.
const Json& array_at(const Json& json, std::string_view path);

}  // namespace sturm
