#pragma once
#include <optional>

#include "lensmodel/light_ray.h"
#include "lensmodel/sag.h"

namespace sturm {

/// A sphere or a plane.
struct SphereSurface {
  double curvature = 0.0;  ///< 1/R [1/m]; R > 0 where the centre lies on the eye's side; 0 is a plane

  /// z(x, y); none outside of the hemisphere about the vertex.
  std::optional<Sag> sag(double x, double y) const;

  /// Distance along the ray to where it crosses the hemisphere about the vertex outward; may be negative; none where it
  /// does not. Closed form without cancellation: exact for a plane too.
  std::optional<double> crossing(const LightRay& ray) const;
};

}  // namespace sturm
