#include "pathtrace/cameras/camera_hits.h"

#include <algorithm>
#include <limits>

#include "pathtrace/cameras/view_camera.h"
#include "pathtrace/scene/embree_rays.h"

namespace sturm {

RTCHit CameraHits::record(int i) const {
  const RTCHit8& p = packets[i / 8].hit;
  const int lane = i % 8;
  RTCHit hit;
  hit.Ng_x = p.Ng_x[lane];
  hit.Ng_y = p.Ng_y[lane];
  hit.Ng_z = p.Ng_z[lane];
  hit.u = p.u[lane];
  hit.v = p.v[lane];
  hit.primID = p.primID[lane];
  hit.geomID = p.geomID[lane];
  hit.instID[0] = p.instID[0][lane];
  return hit;
}

void trace_packets(const Scene& scene, int count, CameraHits& hits) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (int first = 0; first < count; first += 8) {
    RTCRayHit8& packet = hits.packets[first / 8];
    alignas(32) int valid[8];
    for (int lane = 0; lane < 8; ++lane) {
      const int i = first + lane;
      valid[lane] = i < count && goes_on(hits.rays.status[i]) ? -1 : 0;
      packet.ray.org_x[lane] = hits.rays.origin[0][i];
      packet.ray.org_y[lane] = hits.rays.origin[1][i];
      packet.ray.org_z[lane] = hits.rays.origin[2][i];
      packet.ray.dir_x[lane] = hits.rays.direction[0][i];
      packet.ray.dir_y[lane] = hits.rays.direction[1][i];
      packet.ray.dir_z[lane] = hits.rays.direction[2][i];
      packet.ray.tnear[lane] = 0.0f;
      packet.ray.tfar[lane] = std::numeric_limits<float>::infinity();
      packet.ray.time[lane] = 0.0f;
      packet.ray.mask[lane] = ~0u;
      packet.ray.flags[lane] = 0;
      packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
      packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(valid, scene.embree(), &context, &packet);
  }
  for (int i = (count + 7) / 8 * 8; i < CameraRayBlock::size; ++i)
    hits.packets[i / 8].hit.geomID[i % 8] = RTC_INVALID_GEOMETRY_ID;
}

template <class Camera>
void trace_camera_rays(const Scene& scene, const Camera& camera, int x, int y, std::uint32_t first_sample, int count,
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
template void trace_camera_rays(const Scene&, const ViewCamera&, int, int, std::uint32_t, int, const PixelSequence&,
                                CameraHits&);

}  // namespace sturm
