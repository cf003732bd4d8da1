#pragma once
#include <embree3/rtcore.h>

#include "conoid/pictures/ray_shading.h"

namespace sturm {

/// First hits of up to 8 rays at once, `from_m` metres or more from their origins.
class RayPacket {
 public:
  static constexpr int lanes = 8;

  void trace(RTCScene scene, const UnseenPlaces::Ray* rays, int count, float from_m = 0.0f);

  /// In units of the ray's direction; ∞ for nothing.
  float distance(int lane) const { return distance_[lane]; }
  RTCHit hit(int lane) const;  ///< of a lane that met something

 private:
  RTCRayHit8 packet_;
  float distance_[lanes];
};

}  // namespace sturm
