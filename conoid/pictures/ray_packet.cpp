#include "conoid/pictures/ray_packet.h"

#include <limits>

namespace sturm {

void RayPacket::trace(RTCScene scene, const UnseenPlaces::Ray* rays, int count, float from_m) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(32) int valid[lanes];
  for (int i = 0; i < lanes; ++i) {
    const UnseenPlaces::Ray& ray = rays[i < count ? i : 0];
    valid[i] = i < count ? -1 : 0;
    packet_.ray.org_x[i] = ray.origin.x();
    packet_.ray.org_y[i] = ray.origin.y();
    packet_.ray.org_z[i] = ray.origin.z();
    packet_.ray.dir_x[i] = ray.direction.x();
    packet_.ray.dir_y[i] = ray.direction.y();
    packet_.ray.dir_z[i] = ray.direction.z();
    packet_.ray.tnear[i] = from_m > 0.0f ? from_m / ray.direction.norm() : 0.0f;
    packet_.ray.tfar[i] = infinity;
    packet_.ray.time[i] = 0.0f;
    packet_.ray.mask[i] = ~0u;
    packet_.ray.flags[i] = 0;
    packet_.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet_.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect8(valid, scene, &context, &packet_);
  for (int i = 0; i < count; ++i)
    distance_[i] = packet_.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? infinity : packet_.ray.tfar[i];
}

RTCHit RayPacket::hit(int lane) const {
  const RTCHit8& all = packet_.hit;
  RTCHit one;
  one.Ng_x = all.Ng_x[lane];
  one.Ng_y = all.Ng_y[lane];
  one.Ng_z = all.Ng_z[lane];
  one.u = all.u[lane];
  one.v = all.v[lane];
  one.primID = all.primID[lane];
  one.geomID = all.geomID[lane];
  one.instID[0] = all.instID[0][lane];
  return one;
}

}  // namespace sturm
