#include "lensmodel/torus_surface.h"

#include "lensmodel/units.h"

namespace sturm {

TorusSurface::TorusSurface(double sweep_curvature, double generator_curvature, double sweep_meridian_deg)
    : sweep_curvature_(sweep_curvature), generator_curvature_(generator_curvature) {
  const auto [sine, cosine] =
      sine_cosine_of_degrees(180.0 - sweep_meridian_deg);  // the examiner's x is the wearer's −x
  sweep_direction_ = {cosine, sine};
}

std::optional<Sag> TorusSurface::sag(double x, double y) const {
  const auto at = place(x, y);
  if (!at) return std::nullopt;
  const auto [s, p, z0, slope0, m, q] = *at;
  const double cs = sweep_curvature_, ax = sweep_direction_.x(), ay = sweep_direction_.y();
  const double bend0 = generator_curvature_ / (p * p * p);  // the generator's second derivative
  const double q3 = (m * m - cs * cs * s * s) * q;
  const double zss = cs * m * m / q3, zsg = cs * cs * s * m * slope0 / q3,
               zgg = bend0 * m / q + cs * cs * cs * slope0 * slope0 * s * s / q3;
  Eigen::Matrix2d turn, hessian;
  turn << ax, -ay, ay, ax;  // columns: sweep and generator directions
  hessian << zss, zsg, zsg, zgg;
  const SagSlope first = slope(*at);
  return Sag{first.value, first.gradient, turn * hessian * turn.transpose()};
}

}  // namespace sturm
