#include "lensmodel/sphere_surface.h"

#include <cmath>

namespace sturm {

std::optional<Sag> SphereSurface::sag(double x, double y) const {
  const double c = curvature, square = x * x + y * y, p2 = 1.0 - c * c * square;
  if (!(p2 > 0.0)) return std::nullopt;
  const double p = std::sqrt(p2);
  const Eigen::Vector2d gradient(c * x / p, c * y / p);
  return Sag{c * square / (1.0 + p), gradient, c / p * (Eigen::Matrix2d::Identity() + gradient * gradient.transpose())};
}

std::optional<double> SphereSurface::crossing(const LightRay& ray) const {
  // c|P|²/2 − z = 0 with P = o + tN: c t²/2 + b t + e/2 = 0. Outward is the root where the left side grows, at the rate
  // √(b² − ce).
  const double c = curvature;
  const double b = c * ray.origin.dot(ray.direction) - ray.direction.z();
  const double e = c * ray.origin.squaredNorm() - 2.0 * ray.origin.z();
  const double discriminant = b * b - c * e;
  if (!(discriminant > 0.0)) return std::nullopt;
  const double root = std::sqrt(discriminant);
  double t;
  if (b > 0.0)
    t = -e / (b + root);
  else if (c != 0.0)
    t = (root - b) / c;
  else
    return std::nullopt;
  return c * ray.at(t).z() < 1.0 ? std::optional(t) : std::nullopt;  // c z > 1 is the far hemisphere
}

}  // namespace sturm
