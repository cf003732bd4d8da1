#pragma once
#include <cmath>
#include <optional>

#include "lensmodel/sag.h"

namespace sturm {

/// A conic section turned about its axis: z = c r²/(1 + √(1 − (1 + k) c² r²)).
struct ConicSurface {
  double curvature = 0.0;  ///< at the vertex, 1/R [1/m]; R > 0 where the centre lies on the eye's side; 0 is a plane
  double conic_constant = 0.0;  ///< k: −1 parabola, < −1 hyperbola, −1 … 0 ellipse seen from its sharp end, 0 sphere, >
                                ///< 0 from its blunt end

  /// z(x, y); none beyond the widest circle of an ellipsoid.
  std::optional<Sag> sag(double x, double y) const;

  std::optional<SagSlope> slope(double x, double y) const {
    const double square = x * x + y * y, p2 = 1.0 - (1.0 + conic_constant) * curvature * curvature * square;
    if (!(p2 > 0.0)) return std::nullopt;
    const double p = std::sqrt(p2);
    return SagSlope{curvature * square / (1.0 + p), {curvature * x / p, curvature * y / p}};
  }
};

}  // namespace sturm
