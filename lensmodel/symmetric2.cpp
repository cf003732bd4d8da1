#include "lensmodel/symmetric2.h"

#include <cmath>
#include <limits>

namespace sturm {

double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  const double error = std::fma(-c, d, cd);
  return std::fma(a, b, -cd) + error;
}

namespace {
constexpr double relative_isotropy = 4.0 * std::numeric_limits<double>::epsilon();

/// Unit vector at half the angle of (cos 2θ, sin 2θ) ∝ (x, y), without trigonometry; in the right half plane.
Eigen::Vector2d half_angle_direction(double x, double y) {
  const double length = std::hypot(x, y);
  const Eigen::Vector2d doubled =
      x >= 0.0 ? Eigen::Vector2d(length + x, y) : Eigen::Vector2d(std::abs(y), std::copysign(length - x, y));
  return doubled.normalized();
}
}  // namespace

PrincipalValues principal_values(double xx, double xy, double yy) {
  const double mean = 0.5 * (xx + yy), half_difference = 0.5 * (xx - yy);
  const double radius = std::hypot(half_difference, xy);
  const double determinant = difference_of_products(xx, yy, xy, xy);
  const double big = mean >= 0.0 ? mean + radius : mean - radius;  // the one of larger magnitude, no cancellation
  const double little = big != 0.0 ? determinant / big : 0.0;
  const bool isotropic = radius <= relative_isotropy * std::abs(mean) || radius == 0.0;
  const Eigen::Vector2d direction = isotropic ? Eigen::Vector2d(1.0, 0.0) : half_angle_direction(half_difference, xy);
  return mean >= 0.0 ? PrincipalValues{big, little, direction, isotropic}
                     : PrincipalValues{little, big, direction, isotropic};
}

SingularValues singular_values(const Eigen::Matrix2d& m) {
  // M Mᵀ has eigenvalues σ²; with E, F, G, H the four quarter sums, σ = √(E² + H²) ± √(F² + G²).
  const double e = 0.5 * (m(0, 0) + m(1, 1)), f = 0.5 * (m(0, 0) - m(1, 1));
  const double g = 0.5 * (m(1, 0) + m(0, 1)), h = 0.5 * (m(1, 0) - m(0, 1));
  const double q = std::hypot(e, h), r = std::hypot(f, g);
  const double large = q + r;
  const double determinant = difference_of_products(m(0, 0), m(1, 1), m(0, 1), m(1, 0));
  const double small = large > 0.0 ? std::abs(determinant) / large : 0.0;
  const bool isotropic = std::min(q, r) <= relative_isotropy * std::max(q, r);
  if (isotropic) return {large, small, {1.0, 0.0}, true};
  // Left rotation = (atan2(g, f) + atan2(h, e)) / 2; the doubled angle is the product of the two unit complex numbers.
  return {large, small, half_angle_direction(f * e - g * h, g * e + f * h), false};
}

}  // namespace sturm
