#include "lensmodel/spectacles.h"

#include "lensmodel/refraction.h"

namespace sturm {

namespace {

/// The ray in the frame of the surface whose vertex lies at (0, 0, vertex_z).
LightRay in_surface_frame(const LightRay& ray, double vertex_z) {
  return {ray.origin - Eigen::Vector3d(0.0, 0.0, vertex_z), ray.direction};
}

}  // namespace

LensPath trace(const Spectacles& lens, const LightRay& ray) {
  LensPath path;
  const double rim_radius = 0.5 * lens.diameter_m;

  const SurfaceHit back = intersect(lens.back, in_surface_frame(ray, lens.back_vertex_z()), rim_radius);
  path.status = back.status;
  if (path.status != LensStatus::ok) return path;
  path.back_sag = back.sag;
  path.back_point = back.position + Eigen::Vector3d(0.0, 0.0, lens.back_vertex_z());
  const auto inside = refracted(ray.direction, outward_normal(back.sag), 1.0, lens.refractive_index);
  if (!inside) {  // into the denser medium only light that grazes the surface is lost
    path.status = LensStatus::missed_lens;
    return path;
  }
  path.inside_direction = *inside;

  const SurfaceHit front =
      intersect(lens.front, in_surface_frame({path.back_point, path.inside_direction}, lens.front_vertex_z()), rim_radius);
  path.status = front.status;
  if (path.status != LensStatus::ok) return path;
  path.front_sag = front.sag;
  path.exit.origin = front.position + Eigen::Vector3d(0.0, 0.0, lens.front_vertex_z());
  const auto direction = refracted(path.inside_direction, outward_normal(front.sag), lens.refractive_index, 1.0);
  if (!direction) {
    path.status = LensStatus::total_internal_reflection;
    return path;
  }
  path.exit.direction = *direction;
  return path;
}

}  // namespace sturm
