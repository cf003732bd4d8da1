#pragma once
#include <embree3/rtcore.h>

#include "lensmodel/light_ray.h"
#include "pathtrace/cameras/camera.h"
#include "pathtrace/scene/scene.h"

namespace sturm {

/// Camera rays of one block and what they hit. Lanes whose ray was dropped or that lie beyond the last sample hit
/// nothing.
struct CameraHits {
  CameraRayBlock rays;
  alignas(64) RTCRayHit8 packets[CameraRayBlock::size / 8];

  bool hit(int i) const { return packets[i / 8].hit.geomID[i % 8] != RTC_INVALID_GEOMETRY_ID; }
  float distance(int i) const { return packets[i / 8].ray.tfar[i % 8]; }
  RTCHit record(int i) const;
  Eigen::Vector3f origin(int i) const { return {rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]}; }
  Eigen::Vector3f direction(int i) const { return {rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]}; }
};

/// Traces the first `count` of the block's rays, those whose status goes on, in packets of 8.
void trace_packets(const Scene& scene, int count, CameraHits& hits);

/// Generates and traces the camera rays of samples first_sample … of pixel (x, y), `count` ≤ block size of them.
/// Camera: EyeCamera or ViewCamera.
template <class Camera>
void trace_camera_rays(const Scene& scene, const Camera& camera, int x, int y, std::uint32_t first_sample, int count,
                       const PixelSequence& sequence, CameraHits& hits);

/// Distance [m] of what a ray meets first, ∞ for nothing.
double distance_along(const Scene& scene, const LightRay& ray);

}  // namespace sturm
