#pragma once
#include "pathtrace/scene/embree_rays.h"

namespace sturm {

/// Eight shadow rays that are traced together: faster than one by one where they start close to one another and go to
/// the same lights.
class ShadowPacket {
 public:
  static constexpr int size = 8;

  /// Something may lie between origin and origin + direction.
  void add(int lane, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) {
    valid_[lane] = -1;
    set_lane(rays_, lane, origin, direction, shadow_end);
  }

  void trace(RTCScene scene) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded8(valid_, scene, &context, &rays_);
  }

  /// After `trace`: this lane has a ray and something is in its way.
  bool is_stopped(int lane) const { return valid_[lane] != 0 && rays_.tfar[lane] < 0.0f; }

 private:
  alignas(32) int valid_[size] = {};
  RTCRay8 rays_;
};

}  // namespace sturm
