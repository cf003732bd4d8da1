#include "lensmodel/torus_surface.h"

#include <cmath>

#include "lensmodel/units.h"

namespace sturm {

TorusSurface::TorusSurface(double sweep_curvature, double generator_curvature, double sweep_meridian_deg)
    : sweep_curvature_(sweep_curvature), generator_curvature_(generator_curvature) {
  const auto [sine, cosine] =
      sine_cosine_of_degrees(180.0 - sweep_meridian_deg);  // the examiner's x is the wearer's −x
  sweep_direction_ = {cosine, sine};
}

std::optional<Sag> TorusSurface::sag(double x, double y) const {
  const double cs = sweep_curvature_, cg = generator_curvature_;
  const double ax = sweep_direction_.x(), ay = sweep_direction_.y();
  const double s = ax * x + ay * y, g = ax * y - ay * x;  // along the sweep, along the generator's meridian
  const double p2 = 1.0 - cg * cg * g * g;
  if (!(p2 > 0.0)) return std::nullopt;
  const double p = std::sqrt(p2);
  const double z0 = cg * g * g / (1.0 + p), slope0 = cg * g / p,
               bend0 = cg / (p * p * p);  // the generator and its derivatives
  const double m = 1.0 - cs * z0;         // distance to the sweep axis in units of the sweep radius
  const double q2 = m * m - cs * cs * s * s;
  if (!(m > 0.0 && q2 > 0.0)) return std::nullopt;
  const double q = std::sqrt(q2), q3 = q2 * q;
  // z = z0 + w with cs (s² + w²) = 2 m w: the circle about the sweep axis. Implicit derivatives of that:
  const double w = cs * s * s / (m + q);
  const double zs = cs * s / q, zg = slope0 * m / q;
  const double zss = cs * m * m / q3, zsg = cs * cs * s * m * slope0 / q3,
               zgg = bend0 * m / q + cs * cs * cs * slope0 * slope0 * s * s / q3;
  Eigen::Matrix2d turn, hessian;
  turn << ax, -ay, ay, ax;  // columns: sweep and generator directions
  hessian << zss, zsg, zsg, zgg;
  return Sag{z0 + w, turn * Eigen::Vector2d(zs, zg), turn * hessian * turn.transpose()};
}

}  // namespace sturm
