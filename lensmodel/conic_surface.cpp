#include "lensmodel/conic_surface.h"

#include <cmath>

namespace sturm {

std::optional<Sag> ConicSurface::sag(double x, double y) const {
  const double c = curvature, square = x * x + y * y, p2 = 1.0 - (1.0 + conic_constant) * c * c * square;
  if (!(p2 > 0.0)) return std::nullopt;
  const double p = std::sqrt(p2);
  const Eigen::Vector2d gradient(c * x / p, c * y / p);
  return Sag{c * square / (1.0 + p), gradient,
             c / p * (Eigen::Matrix2d::Identity() + (1.0 + conic_constant) * gradient * gradient.transpose())};
}

}  // namespace sturm
