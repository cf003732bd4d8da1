#include "pathtrace/guide/pupil_slopes.h"

#include <numbers>
#include <vector>

#include "pathtrace/sampling/pupil_points.h"

namespace sturm {

PupilSlopes fitted_slopes(const EyeRays<double>& rays) {
  constexpr int radial = 8, azimuthal = 64;
  const double radius = rays.pupil_radius();
  PupilSlopes slopes;
  if (!(radius > 0.0)) return slopes;
  const auto slope_at = [&](const Eigen::Vector2d& unit) -> Eigen::Vector2d {
    const PupilRay<double> ray = rays.through(radius * unit.x(), radius * unit.y());
    return goes_on(ray.status) ? Eigen::Vector2d(ray.sx, ray.sy) : Eigen::Vector2d(0.0, 0.0);
  };
  std::vector<WeightedPoint> points = disk_quadrature(radial, azimuthal);
  for (const WeightedPoint& at : points) {
    const Eigen::Vector2d s = slope_at(at.point);
    slopes.constant += at.weight * s;
    slopes.matrix += (4.0 * at.weight / radius) * s * at.point.transpose();  // the mean of p pᵀ is ¼ over the unit disc
  }
  for (int k = 0; k < azimuthal; ++k) {  // and the rim, where high orders are largest
    const double angle = 2.0 * std::numbers::pi * k / azimuthal;
    points.push_back({{std::cos(angle), std::sin(angle)}, 0.0});
  }
  for (const WeightedPoint& at : points)
    slopes.residual =
        std::max(slopes.residual, (slope_at(at.point) - slopes.constant - radius * slopes.matrix * at.point).norm());
  return slopes;
}

}  // namespace sturm
