#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "pathtrace/lights/emitter_clusters.h"
#include "pathtrace/scene/scene.h"

namespace sturm {

/// Whether guided samples are in use, or why not.
enum class GuideUse : std::uint8_t {
  not_asked,
  in_use,
  no_small_emitter,  ///< nothing that is seen from little of the pupil at a time
  no_pupil,          ///< a pinhole has no choice
  fixed_points,      ///< pupil points in fixed places (rings) have no density
  dropped_rays       ///< metalstigmatism: a dropped ray is no sample at all
};

/// A word for the manifest.
std::string_view name_of(GuideUse use);

/// An emitter that a pixel may see, and the probability of choosing it.
struct GuidedTarget {
  int cluster;
  float probability;
};

/// The target for a uniform number in [0, 1); probabilities sum to 1, `targets` is not empty.
const GuidedTarget& chosen(std::span<const GuidedTarget> targets, float number);

/// What a cluster sends against a ray; none where the ray meets something else first, or the back of it.
std::optional<Eigen::Vector3f> emission_met(const Scene& scene, const EmitterClusters& clusters, int cluster,
                                            const Eigen::Vector3f& origin, const Eigen::Vector3f& direction);

}  // namespace sturm
