#include "conoid/tracing/ray_transfer.h"

namespace sturm {

RayTransfer transferred(const RayTransfer& rays, double distance) {
  RayTransfer moved = rays;
  moved.offset_from_offset += distance * rays.slope_from_offset;
  moved.offset_from_slope += distance * rays.slope_from_slope;
  return moved;
}

RayTransfer on_frame(const RayTransfer& rays, const Eigen::Vector3d& f1, const Eigen::Vector3d& f2) {
  const Eigen::Matrix2d change = change_of_frame(rays.e1, rays.e2, f1, f2);
  return {rays.direction,
          f1,
          f2,
          change * rays.offset_from_offset,
          change * rays.offset_from_slope,
          change * rays.slope_from_offset,
          change * rays.slope_from_slope};
}

RayTransfer through(const RayTransfer& rays, const Interface& at, const SurfaceElement& surface) {
  const RayTransfer in = on_frame(rays, at.u, at.v);
  const Eigen::Matrix2d bend = at.gamma * tangent_curvature(surface, at.u, at.tangent);
  const Eigen::Vector2d c(1.0, at.cos_in), c_inverse(1.0, 1.0 / at.cos_in), out(1.0, at.cos_out),
      out_inverse(1.0, 1.0 / at.cos_out);
  const auto offset = [&](const Eigen::Matrix2d& a) -> Eigen::Matrix2d {
    return out.asDiagonal() * (c_inverse.asDiagonal() * a);
  };
  const auto slope = [&](const Eigen::Matrix2d& a, const Eigen::Matrix2d& b) -> Eigen::Matrix2d {
    const Eigen::Matrix2d on_surface = c_inverse.asDiagonal() * a;
    const Eigen::Matrix2d bent = at.mu * (c.asDiagonal() * b) - bend * on_surface;
    return out_inverse.asDiagonal() * bent;
  };
  return {at.direction_out,
          at.u,
          at.v_out,
          offset(in.offset_from_offset),
          offset(in.offset_from_slope),
          slope(in.offset_from_offset, in.slope_from_offset),
          slope(in.offset_from_slope, in.slope_from_slope)};
}

}  // namespace sturm
