#pragma once
#include <Eigen/Core>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "io/json/json.h"
#include "lensmodel/ellipse.h"

namespace sturm {

// Numbers, vectors and ellipses as the formats want them: what cannot be computed is null, never NaN or infinity.

inline Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}
inline Json number_or_null(const std::optional<double>& value) {
  return value ? number_or_null(*value) : Json(nullptr);
}

/// The same read back.
inline std::optional<double> number_or_none(const Json& value) {
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

/// Distances may be infinite: "inf".
inline Json distance_json(double distance_m) {
  return std::isinf(distance_m) ? Json("inf") : Json(distance_m);
}

inline Json json_of(const Eigen::Vector2d& v) {
  return {number_or_null(v.x()), number_or_null(v.y())};
}
inline Json json_of(const Eigen::Vector3d& v) {
  return {number_or_null(v.x()), number_or_null(v.y()), number_or_null(v.z())};
}

/// [x, y, z] of a validated document.
inline Eigen::Vector3d read_vector3(const Json& value) {
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

/// Symmetric matrix as [xx, xy, yy].
inline Json symmetric_json(const Eigen::Matrix2d& m) {
  return {number_or_null(m(0, 0)), number_or_null(m(0, 1)), number_or_null(m(1, 1))};
}

/// The same read back.
inline Eigen::Matrix2d symmetric_from(const Json& xx_xy_yy) {
  Eigen::Matrix2d m;
  m << xx_xy_yy.at(0).get<double>(), xx_xy_yy.at(1).get<double>(), xx_xy_yy.at(1).get<double>(),
      xx_xy_yy.at(2).get<double>();
  return m;
}

/// Full matrix as rows.
inline Json rows_json(const Eigen::Matrix2d& m) {
  return {{m(0, 0), m(0, 1)}, {m(1, 0), m(1, 1)}};
}

inline Json semi_axes_json(const Ellipse& e, double scale = 1.0) {
  return {number_or_null(scale * e.semi_major), number_or_null(scale * e.semi_minor)};
}

}  // namespace sturm
