#include "experiments/stress/surface_shape.h"

#include <algorithm>

#include "experiments/stress/implicit_surface.h"

namespace sturm::stress {

namespace {

struct Bend {
  std::array<Extended, 2> slope;
  std::array<std::array<Extended, 2>, 2> hessian;
  bool on_sheet;
};

Bend bend_at(const Surface& surface, const Vec3<Extended>& p) {
  const auto g = implicit(surface, p);
  const Extended zx = -g.gradient.x / g.gradient.z, zy = -g.gradient.y / g.gradient.z;
  Vec3<Dual> moved{Dual(p.x, 0), Dual(p.y, 1), Dual(p.z)};
  moved.z.d[0] = zx, moved.z.d[1] = zy;  // along the surface
  const auto around = implicit(surface, moved);
  const Dual to_z = inverse(around.gradient.z), sx = around.gradient.x * to_z, sy = around.gradient.y * to_z;
  return {{zx, zy}, {{{-sx.d[0], -sx.d[1]}, {-sy.d[0], -sy.d[1]}}}, g.on_sheet};
}

Extended difference(const Bend& a, const Bend& b) {
  Extended sum = 0.0L;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      sum += (a.hessian[i][j] - b.hessian[i][j]) * (a.hessian[i][j] - b.hessian[i][j]);
  return std::sqrt(sum);
}

}  // namespace

SurfaceShape shape_at(const Surface& surface, const Vec3<Extended>& p) {
  const Bend here = bend_at(surface, p);
  const Extended size = difference(here, {}), step = 1e-6L * std::min(1e-2L, size > 0.0L ? 1.0L / size : 1e-2L);
  SurfaceShape shape{static_cast<double>(std::hypot(here.slope[0], here.slope[1])), static_cast<double>(size), 0.0};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto beside = [&](Extended h) {  // on the surface to third order
      const Extended dz = h * here.slope[axis] + 0.5L * h * h * here.hessian[axis][axis];
      return bend_at(surface,
                     axis == 0 ? Vec3<Extended>{p.x + h, p.y, p.z + dz} : Vec3<Extended>{p.x, p.y + h, p.z + dz});
    };
    // Third derivatives of a spline jump at its knots, so both sides count; a surface may end on one side.
    for (const Extended h : {step, -step})
      if (const Bend there = beside(h); there.on_sheet)
        shape.hessian_change = std::max(shape.hessian_change, static_cast<double>(difference(there, here) / step));
  }
  return shape;
}

}  // namespace sturm::stress
