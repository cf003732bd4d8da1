#include "lensmodel/conic_surface.h"

#include <cmath>

namespace sturm {

std::optional<Sag> ConicSurface::sag(double x, double y) const {
  const auto first = slope(x, y);
  if (!first) return std::nullopt;
  const Eigen::Vector2d& gradient = first->gradient;
  const double c = curvature, p = std::sqrt(1.0 - (1.0 + conic_constant) * c * c * (x * x + y * y));
  return Sag{first->value, gradient,
             c / p * (Eigen::Matrix2d::Identity() + (1.0 + conic_constant) * gradient * gradient.transpose())};
}

}  // namespace sturm
