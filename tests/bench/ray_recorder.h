#pragma once
#include <embree3/rtcore.h>

#include <cstdint>
#include <vector>

namespace sturm::bench {

/// One query as it was put to Embree; 28 bytes.
struct RecordedRay {
  float origin[3], direction[3];
  bool shadow;  ///< rtcOccluded up to shadow_end, else rtcIntersect without limit
};

/// While one is alive, every ray that the program sends to Embree is also appended to `rays`. Not for several threads
/// at once.
class RayRecorder {
 public:
  explicit RayRecorder(std::vector<RecordedRay>& rays);
  ~RayRecorder();
  RayRecorder(const RayRecorder&) = delete;
  RayRecorder& operator=(const RayRecorder&) = delete;
};

/// Embree itself, past the recorder.
void bare_intersect(RTCScene scene, RTCIntersectContext* context, RTCRayHit* ray);
void bare_occluded(RTCScene scene, RTCIntersectContext* context, RTCRay* ray);

}  // namespace sturm::bench
