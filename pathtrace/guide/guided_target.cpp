#include "pathtrace/guide/guided_target.h"

#include "pathtrace/scene/embree_rays.h"

namespace sturm {

std::string_view name_of(GuideUse use) {
  switch (use) {
    case GuideUse::not_asked:
      return "not_asked";
    case GuideUse::in_use:
      return "in_use";
    case GuideUse::no_small_emitter:
      return "no_small_emitter";
    case GuideUse::no_pupil:
      return "no_pupil";
    case GuideUse::fixed_points:
      return "fixed_points";
    default:
      return "dropped_rays";
  }
}

const GuidedTarget& chosen(std::span<const GuidedTarget> targets, float number) {
  for (const GuidedTarget& target : targets) {
    if (number < target.probability) return target;
    number -= target.probability;
  }
  return targets.back();
}

std::optional<Eigen::Vector3f> emission_met(const Scene& scene, const EmitterClusters& clusters, int cluster,
                                            const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) {
  RTCRayHit hit = ray_from(origin, direction);
  if (!intersect(scene.embree(), hit)) return std::nullopt;
  const SurfacePoint point = scene.surface_point(hit.hit, origin, direction, hit.ray.tfar);
  if (point.emitter < 0 || clusters.cluster_of(point.emitter) != cluster || !(point.normal.dot(direction) < 0.0f))
    return std::nullopt;
  return point.emission;
}

}  // namespace sturm
