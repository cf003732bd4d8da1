#pragma once
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "io/json/json.h"

namespace sturm {

/// Numbers as the formats want them: what cannot be computed is null, never NaN or infinity.
inline Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}
inline Json number_or_null(const std::optional<double>& value) {
  return value ? number_or_null(*value) : Json(nullptr);
}

/// Distances may be infinite: "inf".
inline Json distance_json(double distance_m) {
  return std::isinf(distance_m) ? Json("inf") : Json(distance_m);
}

}  // namespace sturm
