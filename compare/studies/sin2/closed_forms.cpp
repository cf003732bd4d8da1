#include "compare/studies/sin2/closed_forms.h"

#include <cmath>

#include "lensmodel/symmetric2.h"

namespace sturm {

bool has_pole(const Eigen::Matrix2d& f, double focus_distance_m) {
  if (std::isinf(focus_distance_m)) return false;
  const PrincipalValues p = principal_values(f(0, 0), f(0, 1), f(1, 1));
  return (1.0 + focus_distance_m * p.high) * (1.0 + focus_distance_m * p.low) <= 0.0;
}

std::optional<Eigen::Matrix2d> metalstigmatism_covariance(const Eigen::Matrix2d& f, double target_vergence_D,
                                                          double focus_distance_m, double a) {
  const double quarter = 0.25 * a * a;
  // Focused at infinity every ray leaves parallel to the line of sight, whatever the prescription.
  if (std::isinf(focus_distance_m))
    return quarter * target_vergence_D * target_vergence_D * Eigen::Matrix2d::Identity();
  if (has_pole(f, focus_distance_m)) return std::nullopt;
  const PrincipalValues p = principal_values(f(0, 0), f(0, 1), f(1, 1));
  const double d = focus_distance_m, A = 1.0 + d * 0.5 * (p.high + p.low), B = d * 0.5 * (p.high - p.low);
  const double b = B / A, root = std::sqrt((1.0 - b) * (1.0 + b));  // of 1 − b², |b| < 1
  // Means over ψ of 1/(A + B c), c/(A + B c), 1/(A + B c)², c/(A + B c)² with c = cos 2ψ.
  const double i0 = 1.0 / (A * root), i1 = -b / (A * root * (1.0 + root));
  const double k0 = 1.0 / (A * A * root * root * root), k1 = -b * k0;
  const double u = target_vergence_D - 1.0 / d;
  const double mean = u * u + 2.0 * u * i0 / d + k0 / (d * d), along = 2.0 * u * i1 / d + k1 / (d * d);
  const Eigen::Matrix2d axis = p.high_direction * p.high_direction.transpose();
  return quarter * (mean * Eigen::Matrix2d::Identity() + along * (2.0 * axis - Eigen::Matrix2d::Identity()));
}

}  // namespace sturm
