#include "lensmodel/surface_power.h"

#include <cmath>

namespace sturm {

SurfacePower surface_power(const Sag& sag, double refractive_index) {
  // The shape operator is similar to ∇∇z (I + ∇z ∇zᵀ)⁻¹/√(1 + |∇z|²). In the frame of the steepest slope the metric is
  // diagonal.
  const double p = sag.gradient.x(), q = sag.gradient.y(), square = 1.0 + p * p + q * q;
  const double r = sag.hessian(0, 0), s = sag.hessian(0, 1), t = sag.hessian(1, 1), root = std::sqrt(square);
  const double mean = 0.5 * ((1.0 + q * q) * r - 2.0 * p * q * s + (1.0 + p * p) * t) / (square * root);
  // The traceless part of the shape operator on the orthonormal tangents (1, 0, p)/E^½ and their perpendicular: no
  // difference of squares.
  const double e = 1.0 + p * p;
  const double along = r / e, across = (e * e * t - 2.0 * e * p * q * s + p * p * q * q * r) / (e * square),
               mixed = (e * s - p * q * r) / e;
  const double difference = (along - across) / root, twice_mixed = 2.0 * mixed / square;
  return {(refractive_index - 1.0) * mean, (refractive_index - 1.0) * std::hypot(difference, twice_mixed)};
}

}  // namespace sturm
