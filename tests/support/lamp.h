#pragma once
#include <Eigen/Geometry>

#include "pathtrace/scene/scene_description.h"

namespace sturm::testing {

/// A ball of triangles with normals outwards: an octahedron, each face divided into `steps`² triangles, corners on the
/// sphere.
inline Mesh round_lamp(const Eigen::Vector3f& center, float radius, int steps, int material) {
  Mesh mesh;
  mesh.name = "round lamp";
  mesh.material = material;
  const auto corner = [&](const Eigen::Vector3f& p) {
    const Eigen::Vector3f on_sphere = center + radius * p.normalized();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      if ((mesh.positions[i] - on_sphere).norm() < 1e-5f * radius) return static_cast<std::uint32_t>(i);
    mesh.positions.push_back(on_sphere);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  };
  const auto n = static_cast<float>(steps);
  for (int octant = 0; octant < 8; ++octant) {
    const Eigen::Vector3f x(octant & 1 ? -1.0f : 1.0f, 0, 0), y(0, octant & 2 ? -1.0f : 1.0f, 0),
        z(0, 0, octant & 4 ? -1.0f : 1.0f);
    const bool turned = x.cross(y).dot(z) < 0.0f;
    const auto at = [&](int i, int j) {
      const auto a = static_cast<float>(i) / n, b = static_cast<float>(j) / n;
      return corner(a * x + b * y + (1.0f - a - b) * z);
    };
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      mesh.triangles.push_back(turned ? std::array{a, c, b} : std::array{a, b, c});
    };
    for (int i = 0; i < steps; ++i)
      for (int j = 0; i + j < steps; ++j) {
        add(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < steps) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  return mesh;
}

}  // namespace sturm::testing
