#pragma once
#include <Eigen/Core>
#include <vector>

#include "pathtrace/lights/light_set.h"

namespace sturm {

/// An emitter as the eye sees it: a sphere light, or all emitting triangles that hang together, in a bounding sphere.
struct EmitterCluster {
  Eigen::Vector3f center;  ///< [m]
  float radius;            ///< [m]
  float luminance;         ///< largest of its emitted radiance
};

/// The surface lights of a scene, put together to clusters. Triangles hang together where they share a corner exactly.
class EmitterClusters {
 public:
  explicit EmitterClusters(const LightSet& lights);

  const std::vector<EmitterCluster>& clusters() const { return clusters_; }

  /// Which cluster a light belongs to; −1 for point lights.
  int cluster_of(int light) const { return cluster_of_light_[static_cast<std::size_t>(light)]; }

 private:
  std::vector<EmitterCluster> clusters_;
  std::vector<int> cluster_of_light_;
};

}  // namespace sturm
