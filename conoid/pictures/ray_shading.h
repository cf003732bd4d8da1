#pragma once
#include <embree3/rtcore.h>

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace sturm {

/// What the conoid asks of a scene: what a ray meets first, and whether that gives light of its own towards the ray.
struct SeenScene {
  RTCScene embree;
  std::function<bool(const RTCHit& hit, const Eigen::Vector3f& direction)> emits;
};

/// Rays that see places which a sharp view does not show, place by place: those of place i are first[i] … first[i + 1]
/// − 1.
struct UnseenPlaces {
  struct Ray {
    Eigen::Vector3f origin, direction;
  };
  std::vector<Ray> rays;
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint64_t> keys;  ///< of each place: the same for the same place of the same view

  std::size_t count() const { return keys.size(); }
};

/// Radiance that comes towards the eye from each place: the mean over its rays. It is somebody else's to shade.
using PlaceShader = std::function<std::vector<Eigen::Vector3f>(const UnseenPlaces&)>;

}  // namespace sturm
