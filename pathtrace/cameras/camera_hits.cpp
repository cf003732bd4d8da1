#include "pathtrace/cameras/camera_hits.h"

#include <limits>

#include "pathtrace/cameras/eye_camera.h"
#include "pathtrace/cameras/general_camera.h"
#include "pathtrace/scene/embree_rays.h"

namespace sturm {

void trace_packets(const Scene& scene, int count, CameraHits& hits) {
  constexpr int lanes = HitPacket::size;
  for (int first = 0; first < CameraRayBlock::size; first += lanes) {
    HitPacket& packet = hits.packets[first / lanes];
    if (first >= count) {
      packet.forget_hits();
      continue;
    }
    for (int lane = 0; lane < lanes; ++lane) {
      const int i = first + lane;
      packet.set(lane, hits.origin(i), hits.direction(i), i < count && goes_on(hits.rays.status[i]));
    }
    packet.first_hits(scene.embree());
  }
}

template <Camera C>
void trace_camera_rays(const Scene& scene, const C& camera, int x, int y, std::uint32_t first_sample, int count,
                       const PixelSequence& sequence, CameraHits& hits) {
  camera.generate(x, y, first_sample, sequence, hits.rays);
  trace_packets(scene, count, hits);
}

double distance_along(const Scene& scene, const LightRay& ray) {
  RTCRayHit hit = ray_from(ray.origin.cast<float>(), ray.direction.cast<float>());
  return intersect(scene.embree(), hit) ? static_cast<double>(hit.ray.tfar) : std::numeric_limits<double>::infinity();
}

template void trace_camera_rays(const Scene&, const EyeCamera&, int, int, std::uint32_t, int, const PixelSequence&,
                                CameraHits&);
template void trace_camera_rays(const Scene&, const GeneralCamera&, int, int, std::uint32_t, int, const PixelSequence&,
                                CameraHits&);

}  // namespace sturm
