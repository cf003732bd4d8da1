#include "bench/ray_recorder.h"

namespace {
std::vector<sturm::bench::RecordedRay>* recording = nullptr;
}

// The linker's --wrap turns every call of f into __wrap_f and leaves f itself as __real_f.
extern "C" {
void __real_rtcIntersect1(RTCScene scene, RTCIntersectContext* context, RTCRayHit* ray);
void __real_rtcIntersect8(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit8* rays);
void __real_rtcOccluded1(RTCScene scene, RTCIntersectContext* context, RTCRay* ray);
void __real_rtcOccluded8(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRay8* rays);

void __wrap_rtcIntersect1(RTCScene scene, RTCIntersectContext* context, RTCRayHit* ray) {
  if (recording) {
    const RTCRay& r = ray->ray;
    recording->push_back({{r.org_x, r.org_y, r.org_z}, {r.dir_x, r.dir_y, r.dir_z}, false});
  }
  __real_rtcIntersect1(scene, context, ray);
}

void __wrap_rtcIntersect8(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit8* rays) {
  if (recording) {
    const RTCRay8& r = rays->ray;
    for (int i = 0; i < 8; ++i)
      if (valid[i])
        recording->push_back({{r.org_x[i], r.org_y[i], r.org_z[i]}, {r.dir_x[i], r.dir_y[i], r.dir_z[i]}, false});
  }
  __real_rtcIntersect8(valid, scene, context, rays);
}

void __wrap_rtcOccluded1(RTCScene scene, RTCIntersectContext* context, RTCRay* ray) {
  if (recording)
    recording->push_back({{ray->org_x, ray->org_y, ray->org_z}, {ray->dir_x, ray->dir_y, ray->dir_z}, true});
  __real_rtcOccluded1(scene, context, ray);
}

void __wrap_rtcOccluded8(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRay8* rays) {
  if (recording) {
    const RTCRay8& r = *rays;
    for (int i = 0; i < 8; ++i)
      if (valid[i])
        recording->push_back({{r.org_x[i], r.org_y[i], r.org_z[i]}, {r.dir_x[i], r.dir_y[i], r.dir_z[i]}, true});
  }
  __real_rtcOccluded8(valid, scene, context, rays);
}
}

namespace sturm::bench {

RayRecorder::RayRecorder(std::vector<RecordedRay>& rays) {
  recording = &rays;
}
RayRecorder::~RayRecorder() {
  recording = nullptr;
}

void bare_intersect(RTCScene scene, RTCIntersectContext* context, RTCRayHit* ray) {
  __real_rtcIntersect1(scene, context, ray);
}
void bare_occluded(RTCScene scene, RTCIntersectContext* context, RTCRay* ray) {
  __real_rtcOccluded1(scene, context, ray);
}

}  // namespace sturm::bench
