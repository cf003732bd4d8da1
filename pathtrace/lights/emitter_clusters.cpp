#include "pathtrace/lights/emitter_clusters.h"

#include <array>
#include <map>
#include <numeric>

#include "pathtrace/sampling/vector_math.h"

namespace sturm {

namespace {

/// Sets that grow together (union–find with path halving).
class Groups {
 public:
  explicit Groups(int n) : parent_(static_cast<std::size_t>(n)) { std::iota(parent_.begin(), parent_.end(), 0); }
  int root(int i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  void join(int a, int b) { at(root(a)) = root(b); }

 private:
  int& at(int i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<int> parent_;
};

struct Box {
  Eigen::Vector3f lower = Eigen::Vector3f::Constant(HUGE_VALF), upper = Eigen::Vector3f::Constant(-HUGE_VALF);
  void add(const Eigen::Vector3f& p) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
};

}  // namespace

EmitterClusters::EmitterClusters(const LightSet& lights)
    : cluster_of_light_(static_cast<std::size_t>(lights.size()), -1) {
  Groups groups(lights.size());
  std::map<std::array<float, 4>, int> first_at;  // the first triangle that has this corner, on this side
  for (int i = 0; i < lights.size(); ++i) {
    const LightShape shape = lights.shape(i);
    for (const Eigen::Vector3f& c : shape.corners) {
      const auto [there, fresh] = first_at.try_emplace({c.x(), c.y(), c.z(), shape.behind ? 1.0f : 0.0f}, i);
      if (!fresh) groups.join(there->second, i);
    }
  }
  std::map<int, int> cluster_of_root;
  std::vector<Box> boxes;
  for (int i = 0; i < lights.size(); ++i) {
    const LightShape shape = lights.shape(i);
    if (shape.corners.empty() && !(shape.radius > 0.0f)) continue;  // a point light
    const int cluster = cluster_of_root.try_emplace(groups.root(i), static_cast<int>(clusters_.size())).first->second;
    if (cluster == static_cast<int>(clusters_.size())) {
      clusters_.push_back({shape.center, shape.radius, 0.0f});
      boxes.emplace_back();
    }
    cluster_of_light_[static_cast<std::size_t>(i)] = cluster;
    EmitterCluster& c = clusters_[static_cast<std::size_t>(cluster)];
    c.luminance = std::max(c.luminance, sturm::luminance(shape.emission));
    for (const Eigen::Vector3f& corner : shape.corners) boxes[static_cast<std::size_t>(cluster)].add(corner);
  }
  for (std::size_t k = 0; k < clusters_.size(); ++k)
    if (boxes[k].lower.x() <= boxes[k].upper.x()) clusters_[k].center = 0.5f * (boxes[k].lower + boxes[k].upper);
  for (int i = 0; i < lights.size(); ++i) {
    if (cluster_of(i) < 0) continue;
    EmitterCluster& c = clusters_[static_cast<std::size_t>(cluster_of(i))];
    for (const Eigen::Vector3f& corner : lights.shape(i).corners)
      c.radius = std::max(c.radius, (corner - c.center).norm());
  }
}

}  // namespace sturm
