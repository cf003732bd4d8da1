#include "lensmodel/ellipse.h"

#include <algorithm>
#include <cmath>

#include "lensmodel/symmetric2.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {
std::optional<double> orientation_of(const Eigen::Vector2d& direction, bool isotropic) {
  if (isotropic) return std::nullopt;
  return line_direction_deg(std::atan2(direction.y(), direction.x()));
}
}  // namespace

Ellipse Ellipse::image_of_disc(const Eigen::Matrix2d& map, double radius) {
  const SingularValues s = singular_values(map);
  return {radius * s.large, radius * s.small, orientation_of(s.large_direction, s.isotropic || radius == 0.0)};
}

Ellipse Ellipse::of_second_moments(const Eigen::Matrix2d& covariance) {
  const PrincipalValues p = principal_values(covariance(0, 0), covariance(0, 1), covariance(1, 1));
  return {2.0 * std::sqrt(std::max(0.0, p.high)), 2.0 * std::sqrt(std::max(0.0, p.low)),
          orientation_of(p.high_direction, p.isotropic)};
}

Eigen::Matrix2d covariance_of_disc_image(const Eigen::Matrix2d& map, double radius) {
  return 0.25 * radius * radius * map * map.transpose();
}

}  // namespace sturm
