#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "pathtrace/lights/alias_table.h"

namespace sturm {

class LightSet;

/// Lights that are chosen as one: a point light, a sphere, or all emitting triangles that hang together.
struct LightGroup {
  Eigen::Vector3f center;  ///< [m], of a sphere that holds the group
  float radius;            ///< [m], of that sphere; 0 for a point light
  bool round =
      false;  ///< triangles that fill their sphere so well that directions are drawn in the cone under which it is seen
  bool parallelogram = false;  ///< two triangles that are sampled as one: corner + u·edge1 + v·edge2, seen from the
                               ///< side of edge1 × edge2
  Eigen::Vector3f corner, edge1, edge2, scaled_normal;  ///< of the parallelogram; its normal has the length of its area
  std::vector<int> lights;
  AliasTable choices;  ///< among `lights`, in proportion to power
};

/// Which lights matter where. Few groups are chosen in proportion to the irradiance that each would send to the point
/// unoccluded,
///
///     E ≈ L A_seen · max(0, n·d + R) · g / max(|d|², R²)²      d from the point to the group's centre, n the surface's
///     normal, R its radius
///
/// where a panel (triangles of one plane, normal m) shows A_seen = A and g = max(0, −m·d), anything else a quarter of
/// its area (the mean over all directions, for convex bodies by Cauchy's formula) and g = |d|. The first factor bounds
/// the cosine over the whole group, so nothing that shines from its rim is left out. A share goes by power alone, since
/// what is near may be hidden. Many groups are chosen by power only, in constant time.
class LightGroups {
 public:
  static constexpr int most_weighed = 32;        ///< groups up to which each is weighed at every point
  static constexpr float share_by_power = 0.1f;  ///< of all choices

  LightGroups() = default;
  explicit LightGroups(const LightSet& lights);

  const LightGroup& group(int index) const { return groups_[static_cast<std::size_t>(index)]; }
  int group_of(int light) const { return group_of_light_[static_cast<std::size_t>(light)]; }
  int size() const { return static_cast<int>(groups_.size()); }

  struct Choice {
    int group;
    float probability;  ///< 0: no light can shine there
    float rest;         ///< uniform in [0, 1) again
  };
  /// Chooses by the uniform number u for a surface at `point`, lit from the side of its unit normal; normal 0: from any
  /// side.
  Choice choose(const Eigen::Vector3f& point, const Eigen::Vector3f& normal, float u) const {
    return size() == 1 ? Choice{0, 1.0f, u} : choose_among(point, normal, u);
  }

  /// Probability of that choice.
  float probability(int group, const Eigen::Vector3f& point, const Eigen::Vector3f& normal) const;

 private:
  Choice choose_among(const Eigen::Vector3f& point, const Eigen::Vector3f& normal, float u) const;
  using Weights = std::array<float, most_weighed>;
  float weigh(const Eigen::Vector3f& point, const Eigen::Vector3f& normal, Weights& weights) const;

  std::vector<LightGroup> groups_;
  std::vector<int> group_of_light_;
  AliasTable by_power_;
  // Of each group, as structure of arrays so that weighing vectorises: `shown` is L A_seen, `flat` 1 for a panel.
  struct Lanes {
    alignas(64) float x[most_weighed], y[most_weighed], z[most_weighed], radius[most_weighed], shown[most_weighed],
        power[most_weighed], panel_x[most_weighed], panel_y[most_weighed], panel_z[most_weighed], flat[most_weighed];
  };
  Lanes lanes_{};
};

}  // namespace sturm
