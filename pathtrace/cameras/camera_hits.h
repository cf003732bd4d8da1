#pragma once
#include "lensmodel/light_ray.h"
#include "pathtrace/cameras/camera_concept.h"
#include "pathtrace/scene/hit_packet.h"
#include "pathtrace/scene/scene.h"

namespace sturm {

/// Camera rays of one block and what they hit. Lanes whose ray was dropped or that lie beyond the last sample hit
/// nothing.
struct CameraHits {
  CameraRayBlock rays;
  HitPacket packets[CameraRayBlock::size / HitPacket::size];

  bool hit(int i) const { return packets[i / HitPacket::size].hit(i % HitPacket::size); }
  float distance(int i) const { return packets[i / HitPacket::size].distance(i % HitPacket::size); }
  RTCHit record(int i) const { return packets[i / HitPacket::size].record(i % HitPacket::size); }
  Eigen::Vector3f origin(int i) const { return {rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]}; }
  Eigen::Vector3f direction(int i) const { return {rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]}; }
};

/// Traces the first `count` of the block's rays, those whose status goes on, in packets.
void trace_packets(const Scene& scene, int count, CameraHits& hits);

/// Generates and traces the camera rays of samples first_sample … of pixel (x, y), `count` ≤ block size of them. For
/// EyeCamera and GeneralCamera.
template <Camera C>
void trace_camera_rays(const Scene& scene, const C& camera, int x, int y, std::uint32_t first_sample, int count,
                       const PixelSequence& sequence, CameraHits& hits);

/// Distance [m] of what a ray meets first, ∞ for nothing.
double distance_along(const Scene& scene, const LightRay& ray);

}  // namespace sturm
