#include "lensmodel/spectacles.h"

#include "lensmodel/refraction.h"

namespace sturm {

namespace {

LightRay in_lens_frame(const Spectacles& lens, const LightRay& ray) {
  const Eigen::Vector3d from_vertex = ray.origin - lens.back_vertex();
  if (lens.mounting.straight()) return {from_vertex, ray.direction};
  const Eigen::Matrix3d turn = lens.mounting.wearer_from_lens().transpose();
  return {turn * from_vertex, turn * ray.direction};
}

LightRay in_back_frame(const Spectacles& lens, const LightRay& ray) {  // from the lens's frame
  if (!lens.mounting.has_wedge()) return ray;
  const Eigen::Matrix3d turn = lens.mounting.lens_from_back().transpose();
  return {turn * ray.origin, turn * ray.direction};
}

LensPath trace_in_lens_frame(const Spectacles& lens, const LightRay& ray) {
  LensPath path;
  const double rim_radius = 0.5 * lens.diameter_m;

  const Eigen::Matrix3d& turn = lens.mounting.lens_from_back();
  const bool wedge = lens.mounting.has_wedge();
  const SurfaceHit back = intersect(lens.back, in_back_frame(lens, ray), rim_radius);
  path.status = back.status;
  if (path.status != LensStatus::ok) return path;
  path.back = wedge ? SurfaceElement(back.sag).turned(turn) : SurfaceElement(back.sag);
  path.back_point = wedge ? Eigen::Vector3d(turn * back.position) : back.position;
  const auto inside = refracted(ray.direction, path.back.normal, 1.0, lens.refractive_index);
  if (!inside) {  // into the denser medium only light that grazes the surface is lost
    path.status = LensStatus::missed_lens;
    return path;
  }
  path.inside_direction = *inside;

  const Eigen::Vector3d front_vertex(0.0, 0.0, -lens.center_thickness_m);
  const SurfaceHit front = intersect(lens.front, {path.back_point - front_vertex, path.inside_direction}, rim_radius);
  path.status = front.status;
  if (path.status != LensStatus::ok) return path;
  path.front = front.sag;
  path.exit.origin = front.position + front_vertex;
  const auto direction = refracted(path.inside_direction, path.front.normal, lens.refractive_index, 1.0);
  if (!direction) {
    path.status = LensStatus::total_internal_reflection;
    return path;
  }
  path.exit.direction = *direction;
  return path;
}

}  // namespace

bool may_meet(const Spectacles& lens, const LightRay& ray) {
  return may_meet(lens.back, in_back_frame(lens, in_lens_frame(lens, ray)), 0.5 * lens.diameter_m);
}

LensPath trace(const Spectacles& lens, const LightRay& ray) {
  LensPath path = trace_in_lens_frame(lens, in_lens_frame(lens, ray));
  if (path.status != LensStatus::ok) return path;
  const Eigen::Vector3d vertex = lens.back_vertex();
  if (lens.mounting.straight()) {
    path.back_point += vertex;
    path.exit.origin += vertex;
    return path;
  }
  const Eigen::Matrix3d& turn = lens.mounting.wearer_from_lens();
  path.back_point = vertex + turn * path.back_point;
  path.inside_direction = turn * path.inside_direction;
  path.exit = {vertex + turn * path.exit.origin, turn * path.exit.direction};
  path.back = path.back.turned(turn);
  path.front = path.front.turned(turn);
  return path;
}

}  // namespace sturm
