#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace sturm {

/// A ray of the conoid into the scene.
struct SeenRay {
  Eigen::Vector3f origin, direction;  ///< [m] and of any length but 0, world
};

/// What a ray meets first.
struct FirstHit {
  float distance = std::numeric_limits<float>::infinity();  ///< in units of the ray's direction; ∞ for nothing
  bool emits = false;                                       ///< gives light of its own towards the ray
};

/// What the conoid asks of a scene: what each of a few rays that lie close together meets first, `from_m` metres or
/// more from its origin. `hits` has as many entries as `rays`. It is somebody else's to trace; many threads ask at
/// once.
using FirstHits = std::function<void(std::span<const SeenRay> rays, float from_m, std::span<FirstHit> hits)>;

/// Rays that see places which a sharp view does not show, place by place: those of place i are first[i] … first[i + 1]
/// − 1.
struct UnseenPlaces {
  std::vector<SeenRay> rays;
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint64_t> keys;  ///< of each place: the same for the same place of the same view

  std::size_t count() const { return keys.size(); }
};

/// Radiance that comes towards the eye from each place: the mean over its rays. It is somebody else's to shade.
using PlaceShader = std::function<std::vector<Eigen::Vector3f>(const UnseenPlaces&)>;

}  // namespace sturm
