#include "pathtrace/lights/light_groups.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "pathtrace/lights/emitter_clusters.h"
#include "pathtrace/lights/light_set.h"
#include "pathtrace/sampling/vector_math.h"

namespace sturm {

namespace {

/// Rounding of corners: the sphere is a little larger than the farthest of them.
constexpr float sphere_margin = 1.0f + 1e-5f;

/// Triangles whose unit normals agree to this, and whose corners lie this near to one plane for their size, are a
/// panel.
constexpr float flatness = 1e-4f;

/// So near, for its size, the corners of two triangles come to those of a parallelogram: rounding, and not more.
constexpr float closure = 1e-5f;

/// A convex body covers, averaged over all directions, area/4 of its sphere's disc (Cauchy). Up to one half, area
/// sampling loses no more samples to backs of triangles than a cone would to misses.
constexpr float least_cover_of_round = 0.5f;

struct Triangles {
  float area = 0.0f;
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // of a panel
  bool panel = true;
};

Triangles measured(const LightGroup& group, const LightSet& lights) {
  Triangles t;
  for (const int light : group.lights) {
    const std::vector<Eigen::Vector3f> corners = lights.shape(light).corners;
    const Eigen::Vector3f scaled = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    t.area += 0.5f * scaled.norm();
    if (!(scaled.squaredNorm() > 0.0f)) continue;
    const Eigen::Vector3f normal = scaled.normalized();
    if (t.normal.isZero()) t.normal = normal;
    t.panel &= (normal - t.normal).norm() < flatness;
    for (const Eigen::Vector3f& c : corners)
      t.panel &= std::abs(t.normal.dot(c - group.center)) < flatness * group.radius;
  }
  t.panel &= !t.normal.isZero();
  return t;
}

LightGroup group_about(const Eigen::Vector3f& center, float radius) {
  LightGroup group;
  group.center = center;
  group.radius = radius;
  return group;
}

/// Makes two triangles of one panel that share a diagonal and complete each other one parallelogram.
void find_parallelogram(LightGroup& group, const LightSet& lights) {
  if (group.lights.size() != 2) return;
  const LightShape first = lights.shape(group.lights[0]), second = lights.shape(group.lights[1]);
  if (first.emission != second.emission || first.varies || second.varies) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3f &corner = first.corners[i], &next = first.corners[(i + 1) % 3],
                          &last = first.corners[(i + 2) % 3];
    for (std::size_t j = 0; j < 3; ++j) {
      if (second.corners[(j + 1) % 3] != last || second.corners[(j + 2) % 3] != next) continue;
      if ((corner + second.corners[j] - next - last).norm() > closure * group.radius) continue;
      group.parallelogram = true;
      group.corner = corner;
      group.edge1 = next - corner;
      group.edge2 = last - corner;
      group.scaled_normal = group.edge1.cross(group.edge2);
      return;
    }
  }
}

}  // namespace

LightGroups::LightGroups(const LightSet& lights) {
  const EmitterClusters clusters(lights);
  for (const EmitterCluster& c : clusters.clusters()) groups_.push_back(group_about(c.center, c.radius));
  for (int light = 0; light < lights.size(); ++light) {
    const int cluster = clusters.cluster_of(light);
    group_of_light_.push_back(cluster >= 0 ? cluster : size());
    if (cluster < 0) groups_.push_back(group_about(lights.shape(light).center, 0.0f));
    groups_[static_cast<std::size_t>(group_of_light_.back())].lights.push_back(light);
  }
  std::vector<double> powers;
  for (LightGroup& group : groups_) {
    std::vector<double> of_lights;
    double power = 0.0;
    for (const int light : group.lights) {
      of_lights.push_back(lights.power(light));
      power += of_lights.back();
    }
    group.choices = AliasTable(of_lights);
    powers.push_back(power);
  }
  by_power_ = AliasTable(powers);
  for (int i = 0; i < size(); ++i) {
    LightGroup& group = groups_[static_cast<std::size_t>(i)];
    Triangles triangles;
    const bool has_triangles = !lights.shape(group.lights.front()).corners.empty();
    if (has_triangles) {
      triangles = measured(group, lights);
      group.radius *= sphere_margin;
      group.round = !triangles.panel && triangles.area > least_cover_of_round * 4.0f * std::numbers::pi_v<float> *
                                                             group.radius * group.radius;
      if (triangles.panel) find_parallelogram(group, lights);
    }
    if (size() > most_weighed) continue;
    lanes_.x[i] = group.center.x();
    lanes_.y[i] = group.center.y();
    lanes_.z[i] = group.center.z();
    lanes_.radius[i] = group.radius;
    lanes_.power[i] = by_power_.probability(i);
    // Power is π L A of a surface, 4π I of a point.
    const bool flat = has_triangles && triangles.panel;
    lanes_.shown[i] =
        static_cast<float>(powers[static_cast<std::size_t>(i)] / std::numbers::pi) * (flat ? 1.0f : 0.25f);
    lanes_.flat[i] = flat ? 1.0f : 0.0f;
    if (flat) {
      lanes_.panel_x[i] = triangles.normal.x();
      lanes_.panel_y[i] = triangles.normal.y();
      lanes_.panel_z[i] = triangles.normal.z();
    }
  }
}

float LightGroups::weigh(const Eigen::Vector3f& point, const Eigen::Vector3f& normal, Weights& weights) const {
  const bool any_side = normal.isZero(0.0f);
  const float px = point.x(), py = point.y(), pz = point.z(), nx = normal.x(), ny = normal.y(), nz = normal.z();
  const int n = size();
  float irradiance = 0.0f, power = 0.0f;
  for (int i = 0; i < n; ++i) {
    const float dx = lanes_.x[i] - px, dy = lanes_.y[i] - py, dz = lanes_.z[i] - pz;
    const float square = dx * dx + dy * dy + dz * dz, radius = lanes_.radius[i];
    const float distance = std::sqrt(square), bounded = std::max(square, radius * radius);
    const float facing = any_side ? distance + radius : std::max(0.0f, nx * dx + ny * dy + nz * dz + radius);
    const float before = -(lanes_.panel_x[i] * dx + lanes_.panel_y[i] * dy + lanes_.panel_z[i] * dz);
    const float showing = lanes_.flat[i] > 0.0f ? std::max(0.0f, before) : std::max(distance, radius);
    const float e = lanes_.shown[i] * facing * showing / (bounded * bounded);
    weights[static_cast<std::size_t>(i)] = e;
    irradiance += e;
    power += e > 0.0f ? lanes_.power[i] : 0.0f;
  }
  if (!(irradiance > 0.0f)) return 0.0f;
  const float scale = (1.0f - share_by_power) / irradiance, power_scale = share_by_power / power;
  float total = 0.0f;
  for (int i = 0; i < n; ++i) {
    float& w = weights[static_cast<std::size_t>(i)];
    w = w > 0.0f ? w * scale + lanes_.power[i] * power_scale : 0.0f;
    total += w;
  }
  return total;
}

LightGroups::Choice LightGroups::choose_among(const Eigen::Vector3f& point, const Eigen::Vector3f& normal,
                                              float u) const {
  if (size() > most_weighed) {
    const int index = by_power_.choose(u);
    return {index, by_power_.probability(index), u};
  }
  Weights weights;
  const float total = weigh(point, normal, weights);
  if (!(total > 0.0f)) return {0, 0.0f, u};
  float left = u * total;
  int chosen = 0;
  for (int i = 0; i < size(); ++i) {
    const float w = weights[static_cast<std::size_t>(i)];
    if (!(w > 0.0f)) continue;
    chosen = i;
    if (left < w) break;
    left -= w;
  }
  const float weight = weights[static_cast<std::size_t>(chosen)];
  return {chosen, weight / total, std::min(left / weight, 1.0f - 0x1p-24f)};
}

float LightGroups::probability(int group, const Eigen::Vector3f& point, const Eigen::Vector3f& normal) const {
  if (size() == 1) return 1.0f;
  if (size() > most_weighed) return by_power_.probability(group);
  Weights weights;
  const float total = weigh(point, normal, weights);
  return total > 0.0f ? weights[static_cast<std::size_t>(group)] / total : 0.0f;
}

}  // namespace sturm
