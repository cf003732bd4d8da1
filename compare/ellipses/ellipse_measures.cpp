#include "compare/ellipses/ellipse_measures.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "compare/ellipses/ellipse_comparison.h"
#include "compare/ellipses/ellipse_overlap.h"
#include "compare/statistics/random_draws.h"
#include "compare/statistics/running_moments.h"
#include "lensmodel/symmetric2.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

Eigen::Matrix2d positive(const Eigen::Matrix2d& m) {
  const PrincipalValues p = principal_values(m(0, 0), m(0, 1), m(1, 1));
  const Eigen::Vector2d u = p.high_direction, v(-u.y(), u.x());
  return std::max(0.0, p.high) * u * u.transpose() + std::max(0.0, p.low) * v * v.transpose();
}

/// Second moments about `centre` that scatter like the bundle's.
class Scatter {
 public:
  Scatter(const Eigen::Matrix3d& entry_covariance, std::uint64_t seed) : normal_(seed) {
    // Cholesky; a direction without scatter leaves a zero column.
    for (int j = 0; j < 3; ++j) {
      const double pivot = entry_covariance(j, j) - root_.row(j).head(j).squaredNorm();
      if (!(pivot > 1e-14 * entry_covariance(j, j))) continue;
      root_(j, j) = std::sqrt(pivot);
      for (int i = j + 1; i < 3; ++i)
        root_(i, j) = (entry_covariance(i, j) - root_.row(i).head(j).dot(root_.row(j).head(j))) / root_(j, j);
    }
  }

  Eigen::Matrix2d around(const Eigen::Matrix2d& centre) {
    const double a = normal_.next(), b = normal_.next(), c = normal_.next();
    const Eigen::Vector3d step = root_ * Eigen::Vector3d(a, b, c);
    Eigen::Matrix2d change;
    change << step[0], step[1], step[1], step[2];
    return positive(centre + change);
  }

 private:
  NormalDraws normal_;
  Eigen::Matrix3d root_ = Eigen::Matrix3d::Zero();
};

RunningMoments scatter_of(int draws, const std::function<double()>& draw) {
  RunningMoments moments;
  for (int i = 0; i < draws; ++i) moments.add(draw());
  return moments;
}

constexpr double singular_floor =
    64.0 * std::numeric_limits<double>::epsilon();  // of the total variance, as in EllipseComparison

using Distance = std::function<double(const Eigen::Matrix2d&)>;

/// A distance from the prediction that noise makes positive.
EllipseMeasure bootstrapped(const Distance& distance, const BundleEllipse& measured, const Eigen::Matrix2d& predicted,
                            std::uint64_t seed, int draws) {
  EllipseMeasure m;
  m.value = distance(measured.covariance);
  if (!measured.entry_covariance || draws < 2) return m;
  Scatter scatter(*measured.entry_covariance, seed);
  m.standard_error = scatter_of(draws, [&] { return distance(scatter.around(measured.covariance)); }).deviation();
  const RunningMoments noise = scatter_of(draws, [&] { return distance(scatter.around(predicted)); });
  if (noise.deviation() > 0.0) m.z = (m.value - noise.mean()) / noise.deviation();
  return m;
}

EllipseMeasure with_error(double value, const std::optional<double>& error) {
  EllipseMeasure m{value, error, std::nullopt};
  if (error && *error > 0.0) m.z = value / *error;
  return m;
}

std::optional<EllipseMeasure> orientation(const BundleEllipse& measured, const std::optional<double>& difference_deg) {
  if (!difference_deg) return std::nullopt;
  std::optional<double> error;
  if (measured.entry_covariance) {
    const Eigen::Matrix2d& s = measured.covariance;
    const PrincipalValues p = principal_values(s(0, 0), s(0, 1), s(1, 1));
    const Eigen::Vector2d u = p.high_direction, v(-u.y(), u.x());
    const Eigen::Vector3d w = entry_weights(u, v);
    error = std::sqrt(std::max(0.0, w.dot(*measured.entry_covariance * w))) / (p.high - p.low) / radians_per_degree;
  }
  return with_error(*difference_deg, error);
}

std::optional<EllipseMeasure> log_area_ratio(const BundleEllipse& measured, const Eigen::Matrix2d& predicted) {
  const double is = measured.covariance.determinant(), should = predicted.determinant();
  if (!(is > 0.0 && should > 0.0)) return std::nullopt;
  std::optional<double> error;
  if (measured.entry_covariance) {
    const Eigen::Matrix2d inverse = measured.covariance.inverse();
    const Eigen::Vector3d w(inverse(0, 0), 2.0 * inverse(0, 1), inverse(1, 1));  // tr(Σ⁻¹ δΣ)
    error = 0.5 * std::sqrt(std::max(0.0, w.dot(*measured.entry_covariance * w)));
  }
  return with_error(0.5 * std::log(is / should), error);
}

}  // namespace

EllipseMeasures measure_ellipses(const BundleEllipse& measured, const Eigen::Matrix2d& predicted,
                                 const Eigen::Vector2d& offset, std::uint64_t seed, int draws) {
  const EllipseComparison c = compare_to_prediction(measured, predicted);
  const auto axes = measured.semi_axis_standard_errors();
  const Ellipse expected = Ellipse::of_second_moments(predicted);
  // What rounding of the second moments does to a semi-axis: much where the axis is zero, next to nothing elsewhere.
  const double floor = singular_floor * predicted.trace();
  const auto axis = [&](double value, double should, int i) -> EllipseMeasure {
    if (!axes) return with_error(value, std::nullopt);
    const double variance = 0.25 * should * should,
                 rounding = 2.0 * (std::sqrt(variance + floor) - std::sqrt(variance));
    return with_error(value, std::hypot((*axes)[i], rounding));
  };
  EllipseMeasures m;
  m.semi_major = axis(c.semi_major_error, expected.semi_major, 0);
  m.semi_minor = axis(c.semi_minor_error, expected.semi_minor, 1);
  m.orientation = orientation(measured, c.orientation_error_deg);
  const bool has_area = expected.semi_minor > near_zero_axis_ratio * expected.semi_major;
  if (has_area) m.log_area_ratio = log_area_ratio(measured, predicted);
  m.frobenius =
      bootstrapped([&](const Eigen::Matrix2d& s) { return (s - predicted).norm(); }, measured, predicted, seed, draws);
  m.bures_wasserstein = bootstrapped([&](const Eigen::Matrix2d& s) { return bures_wasserstein_distance(s, predicted); },
                                     measured, predicted, seed, draws);
  if (!has_area) return m;
  const FilledEllipse should = FilledEllipse::of_second_moments(predicted, offset);
  const auto missing = [&](const Eigen::Matrix2d& s) {
    return 1.0 - intersection_over_union(FilledEllipse::of_second_moments(s), should).value_or(1.0);
  };
  m.missing_overlap = bootstrapped(missing, measured, predicted, seed, draws);
  return m;
}

}  // namespace sturm
