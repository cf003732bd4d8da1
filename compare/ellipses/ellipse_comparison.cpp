#include "compare/ellipses/ellipse_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lensmodel/symmetric2.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr double rounding_floor = 64.0 * std::numeric_limits<double>::epsilon();

Eigen::Vector3d z_along(const PrincipalValues& axes, const BundleEllipse& measured, const Eigen::Matrix2d& predicted) {
  const Eigen::Vector2d u = axes.high_direction, v(-u.y(), u.x());
  const double floor = rounding_floor * predicted.trace();
  const Eigen::Matrix2d difference = measured.covariance - predicted;
  const auto z = [&](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
    const Eigen::Vector3d w = entry_weights(p, q);
    const double deviation = p.dot(difference * q);
    const double error = std::sqrt(std::max(0.0, w.dot(*measured.entry_covariance * w)) + floor * floor);
    if (error > 0.0) return deviation / error;
    return deviation == 0.0 ? 0.0 : std::copysign(std::numeric_limits<double>::max(), deviation);
  };
  return {z(u, u), z(v, v), z(u, v)};
}

std::optional<double> orientation_error(const Ellipse& measured, const Ellipse& predicted) {
  const auto is_circle = [](const Ellipse& e) {
    return !e.orientation_deg || e.semi_minor > circle_axis_ratio * e.semi_major;
  };
  if (is_circle(measured) || is_circle(predicted)) return std::nullopt;
  const double folded = std::remainder(*measured.orientation_deg - *predicted.orientation_deg, 180.0);
  return folded <= -90.0 ? folded + 180.0 : folded;
}

/// Square root of a positive semidefinite matrix: (A + √det·I)/√(tr + 2√det).
Eigen::Matrix2d square_root(const Eigen::Matrix2d& a) {
  const double root_det = std::sqrt(std::max(0.0, difference_of_products(a(0, 0), a(1, 1), a(0, 1), a(1, 0))));
  const double scale = std::sqrt(a.trace() + 2.0 * root_det);
  if (!(scale > 0.0)) return Eigen::Matrix2d::Zero();
  return (a + root_det * Eigen::Matrix2d::Identity()) / scale;
}

}  // namespace

EllipseComparison compare_to_prediction(const BundleEllipse& measured, const Eigen::Matrix2d& predicted) {
  EllipseComparison c;
  const PrincipalValues axes = principal_values(predicted(0, 0), predicted(0, 1), predicted(1, 1));
  const Ellipse expected = Ellipse::of_second_moments(predicted);
  if (measured.entry_covariance) {
    c.z = z_along(axes, measured, predicted);
    c.z_max = c.z->cwiseAbs().maxCoeff();
  }
  c.semi_major_error = measured.ellipse.semi_major - expected.semi_major;
  c.semi_minor_error = measured.ellipse.semi_minor - expected.semi_minor;
  if (predicted.norm() > 0.0) {
    c.relative_frobenius = (measured.covariance - predicted).norm() / predicted.norm();
    c.semi_major_relative_error = c.semi_major_error / expected.semi_major;
    if (expected.semi_minor > near_zero_axis_ratio * expected.semi_major)
      c.semi_minor_relative_error = c.semi_minor_error / expected.semi_minor;
  }
  c.orientation_error_deg = orientation_error(measured.ellipse, expected);
  c.bures_wasserstein = bures_wasserstein_distance(measured.covariance, predicted);
  return c;
}

double bures_wasserstein_distance(const Eigen::Matrix2d& a, const Eigen::Matrix2d& b) {
  const Eigen::Matrix2d root_a = square_root(a), root_b = square_root(b);
  // The best rotation is the polar factor of √B √A, whose determinant is never negative.
  const Eigen::Matrix2d m = root_b * root_a;
  const double cosine = m(0, 0) + m(1, 1), sine = m(1, 0) - m(0, 1), length = std::hypot(cosine, sine);
  Eigen::Matrix2d rotation = Eigen::Matrix2d::Identity();
  if (length > 0.0) rotation << cosine / length, -sine / length, sine / length, cosine / length;
  return (root_a - root_b * rotation).norm();
}

Eigen::Matrix2d sin2_closed_form_covariance(const Eigen::Matrix2d& v, double a) {
  const double mean = 0.5 * v.trace();
  const Eigen::Matrix2d deviator = v - mean * Eigen::Matrix2d::Identity();
  const double delta_squared = 0.5 * deviator.squaredNorm();
  return 0.25 * a * a * ((mean * mean + 0.5 * delta_squared) * Eigen::Matrix2d::Identity() + mean * deviator);
}

}  // namespace sturm
