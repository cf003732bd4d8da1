#pragma once
#include <Eigen/Core>

#include "lensmodel/gaze.h"
#include "lensmodel/light_ray.h"

namespace sturm {

/// Rows: the axes that the smallest rotation of −z to the chief ray makes of x and y.
inline Eigen::Matrix<double, 2, 3> axes_across(const LightRay& chief) {
  return smallest_rotation({0.0, 0.0, -1.0}, chief.direction).leftCols<2>().transpose();
}

/// Where a ray passes the plane across the chief ray at its origin, on `axes_across` of the chief ray [m].
inline Eigen::Vector2d offset_across(const Eigen::Matrix<double, 2, 3>& across, const LightRay& chief,
                                     const LightRay& ray) {
  const Eigen::Vector3d w = ray.origin - chief.origin;
  return across * (w - w.dot(chief.direction) / ray.direction.dot(chief.direction) * ray.direction);
}

}  // namespace sturm
