#pragma once
#include <limits>

#include "pathtrace/scene/embree_rays.h"

namespace sturm {

/// Up to eight rays and what each of them meets first. Traced together they are faster than one by one where they start
/// close to one another and go about the same way.
class HitPacket {
 public:
  static constexpr int size = 8;

  /// Puts a ray into a lane; one that is not `asked` meets nothing.
  void set(int lane, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, bool asked = true) {
    asked_[lane] = asked ? -1 : 0;
    set_lane(packet_.ray, lane, origin, direction, std::numeric_limits<float>::infinity());
  }

  /// What comes before t, in units of the direction, the ray of the lane passes by.
  void start_at(int lane, float t) { packet_.ray.tnear[lane] = t; }

  /// First hits of all lanes that are asked.
  void first_hits(RTCScene scene) {
    forget_hits();
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect8(asked_, scene, &context, &packet_);
  }

  void forget_hits() {
    for (int lane = 0; lane < size; ++lane) {
      packet_.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
      packet_.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
    }
  }

  bool hit(int lane) const { return packet_.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID; }

  /// In units of the direction; of a lane that hit something.
  float distance(int lane) const { return packet_.ray.tfar[lane]; }
  RTCHit record(int lane) const {
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

 private:
  alignas(32) int asked_[size] = {};
  RTCRayHit8 packet_;
};

}  // namespace sturm
