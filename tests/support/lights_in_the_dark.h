#pragma once
#include "support/scenes.h"

namespace sturm::testing {

/// An octahedron of emitting triangles, normals outwards.
inline Mesh lamp(const Eigen::Vector3f& center, float radius, int material) {
  using Eigen::Vector3f;
  Mesh mesh;
  mesh.name = "lamp";
  for (const Vector3f& corner : {Vector3f(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}})
    mesh.positions.push_back(center + radius * corner);
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  mesh.material = material;
  return mesh;
}

/// Two spheres and two lamps at 0.4 to 3 m, one of each half behind a black card, before a dim wall. `scale` 1: so
/// small that a hundred plain samples of a pixel in their blur hit them less than once; their power does not depend on
/// it.
inline SceneDescription lights_in_the_dark(float scale = 1.0f) {
  using Eigen::Vector3f;
  SceneDescription d;
  d.materials = {
      lambertian({0.5f, 0.5f, 0.5f}), lambertian(Vector3f::Zero(), Vector3f(9e4f, 7e4f, 4e4f) / (scale * scale)),
      lambertian(Vector3f::Zero(), Vector3f(3e4f, 3e4f, 9e4f) / (scale * scale)), lambertian(Vector3f::Zero())};
  d.meshes = {parallelogram({-3, -3, -4}, {6, 0, 0}, {0, 6, 0}, 0), lamp({0.02f, 0.012f, -0.8f}, 0.00008f * scale, 1),
              lamp({-0.05f, -0.06f, -2.0f}, 0.0003f * scale, 2),
              parallelogram({-0.0505f, -0.3f, -1.2f}, {0, 0.3f, 0}, {0.3f, 0, 0}, 3)};
  d.spheres = {{{-0.008f, 0.01f, -0.4f}, 0.00004f * scale, 1}, {{0.06f, -0.09f, -3.0f}, 0.0004f * scale, 2}};
  return d;
}

}  // namespace sturm::testing
