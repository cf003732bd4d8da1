#include "compare/ellipses/accuracy_split.h"

#include <algorithm>
#include <cmath>

#include "lensmodel/ellipse.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

/// Rounding of a covariance relative to its size: of the quadrature's sums and of the points on the surfaces.
constexpr double relative_rounding = 1e-12;

double half_width(const Eigen::Matrix2d& covariance, const Eigen::Vector2d& u) {
  return 2.0 * std::sqrt(std::max(0.0, u.dot(covariance * u)));
}

}  // namespace

CovarianceError covariance_error(const Eigen::Matrix2d& is, const Eigen::Matrix2d& should) {
  CovarianceError error;
  if (should.norm() > 0.0) error.relative_frobenius = (is - should).norm() / should.norm();
  const Ellipse a = Ellipse::of_second_moments(is), b = Ellipse::of_second_moments(should);
  error.semi_axes = {a.semi_major - b.semi_major, a.semi_minor - b.semi_minor};
  const auto look_along = [&](double degrees) {
    const SineCosine angle = sine_cosine_of_degrees(degrees);
    const Eigen::Vector2d u(angle.cosine, angle.sine);
    error.half_width = std::max(error.half_width, std::abs(half_width(is, u) - half_width(should, u)));
  };
  for (int degrees = 0; degrees < 180; ++degrees) look_along(degrees);
  for (const Ellipse& e : {a, b})
    if (e.orientation_deg) {
      look_along(*e.orientation_deg);
      look_along(*e.orientation_deg + 90.0);
    }
  return error;
}

std::optional<double> convergence_order(double error_small, double error_large, double size_small, double size_large,
                                        double rounding) {
  if (!(error_small > rounding && error_large > rounding && size_large > size_small && size_small > 0.0))
    return std::nullopt;
  return std::log(error_large / error_small) / std::log(size_large / size_small);
}

OrderFit fit_orders(const Eigen::Matrix2d& x, const Eigen::Matrix2d& small, double small_radius_m,
                    const Eigen::Matrix2d& large, double large_radius_m) {
  OrderFit fit;
  const double error_small = (small - covariance_of_disc_image(x, small_radius_m)).norm(),
               error_large = (large - covariance_of_disc_image(x, large_radius_m)).norm();
  fit.absolute =
      convergence_order(error_small, error_large, small_radius_m, large_radius_m, relative_rounding * small.norm());
  if (small.norm() > 0.0 && large.norm() > 0.0)
    fit.relative = convergence_order(error_small / small.norm(), error_large / large.norm(), small_radius_m,
                                     large_radius_m, relative_rounding);
  const double a2 = small_radius_m * small_radius_m, b2 = large_radius_m * large_radius_m;
  const Eigen::Matrix2d limit = (b2 * (small / a2) - a2 * (large / b2)) / (b2 - a2),
                        expected = covariance_of_disc_image(x, 1.0);
  if (expected.norm() > 0.0) fit.limit_relative = (limit - expected).norm() / expected.norm();
  return fit;
}

}  // namespace sturm
