#pragma once
#include <embree3/rtcore.h>

#include <Eigen/Core>
#include <limits>

namespace sturm {

/// Shadow rays end this fraction before the light, so that the light does not shadow itself.
inline constexpr float shadow_end = 1.0f - 1e-4f;

inline RTCRayHit ray_from(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) {
  RTCRayHit r;
  r.ray.org_x = origin.x();
  r.ray.org_y = origin.y();
  r.ray.org_z = origin.z();
  r.ray.dir_x = direction.x();
  r.ray.dir_y = direction.y();
  r.ray.dir_z = direction.z();
  r.ray.tnear = 0.0f;
  r.ray.tfar = std::numeric_limits<float>::infinity();
  r.ray.time = 0.0f;
  r.ray.mask = ~0u;
  r.ray.flags = 0;
  r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return r;
}

/// Puts a ray into a lane of a packet, [0, tfar] of it.
inline void set_lane(RTCRay8& rays, int lane, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                     float tfar) {
  rays.org_x[lane] = origin.x();
  rays.org_y[lane] = origin.y();
  rays.org_z[lane] = origin.z();
  rays.dir_x[lane] = direction.x();
  rays.dir_y[lane] = direction.y();
  rays.dir_z[lane] = direction.z();
  rays.tnear[lane] = 0.0f;
  rays.tfar[lane] = tfar;
  rays.time[lane] = 0.0f;
  rays.mask[lane] = ~0u;
  rays.flags[lane] = 0;
}

/// True where the ray hit something; then ray.tfar and hit are set.
inline bool intersect(RTCScene scene, RTCRayHit& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &ray);
  return ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

/// True where something lies between origin and origin + direction.
inline bool occluded(RTCScene scene, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = ray_from(origin, direction).ray;
  ray.tfar = shadow_end;
  rtcOccluded1(scene, &context, &ray);
  return ray.tfar < 0.0f;
}

}  // namespace sturm
