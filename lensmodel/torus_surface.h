#pragma once
#include <cmath>
#include <optional>

#include "lensmodel/sag.h"

namespace sturm {

/// A torus: a circle (the generator), which stands in the meridian perpendicular to the sweep meridian, is swept about
/// an axis parallel to that perpendicular meridian. Either curvature may be 0: then it is a cylinder, or a plane.
class TorusSurface {
 public:
  /// Curvatures 1/R [1/m], R > 0 where the centre lies on the eye's side; `sweep_meridian_deg` in TABO degrees
  /// (examiner's frame).
  TorusSurface(double sweep_curvature, double generator_curvature, double sweep_meridian_deg);

  /// z(x, y); none beyond the generating circle or past the sweep axis.
  std::optional<Sag> sag(double x, double y) const;

  std::optional<SagSlope> slope(double x, double y) const {
    const auto at = place(x, y);
    return at ? std::optional(slope(*at)) : std::nullopt;
  }

  double sweep_curvature() const { return sweep_curvature_; }
  double generator_curvature() const { return generator_curvature_; }
  const Eigen::Vector2d& sweep_direction() const { return sweep_direction_; }  ///< unit vector, wearer frame

 private:
  /// A point of the surface between the formulas for its height and its derivatives: s along the sweep, on the circle
  /// about the sweep axis through the generator's point (g, z0), which has the slope slope0 there. m is that circle's
  /// radius in units of the sweep radius, q its height above s in the same units.
  struct Place {
    double s, p, z0, slope0, m, q;
  };

  std::optional<Place> place(double x, double y) const {
    const double cs = sweep_curvature_, cg = generator_curvature_;
    const double ax = sweep_direction_.x(), ay = sweep_direction_.y();
    const double s = ax * x + ay * y, g = ax * y - ay * x;  // along the sweep, along the generator's meridian
    const double p2 = 1.0 - cg * cg * g * g;
    if (!(p2 > 0.0)) return std::nullopt;
    const double p = std::sqrt(p2), z0 = cg * g * g / (1.0 + p);
    const double m = 1.0 - cs * z0;
    const double q2 = m * m - cs * cs * s * s;
    if (!(m > 0.0 && q2 > 0.0)) return std::nullopt;
    return Place{s, p, z0, cg * g / p, m, std::sqrt(q2)};
  }

  /// z = z0 + w with cs (s² + w²) = 2 m w: the circle about the sweep axis. The gradient is its implicit derivative.
  SagSlope slope(const Place& at) const {
    const double cs = sweep_curvature_, ax = sweep_direction_.x(), ay = sweep_direction_.y();
    const double w = cs * at.s * at.s / (at.m + at.q);
    const double zs = cs * at.s / at.q, zg = at.slope0 * at.m / at.q;
    return {at.z0 + w, {ax * zs - ay * zg, ay * zs + ax * zg}};
  }

  double sweep_curvature_, generator_curvature_;
  Eigen::Vector2d sweep_direction_;
};

}  // namespace sturm
