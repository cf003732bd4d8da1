#include "pathtrace/scene/smooth_normals.h"

#include <Eigen/Geometry>

namespace sturm {

bool normals_bend(const Mesh& mesh, const std::vector<Eigen::Vector3f>& normals) {
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3f& a = mesh.positions[triangle[0]];
    const Eigen::Vector3f face = (mesh.positions[triangle[1]] - a).cross(mesh.positions[triangle[2]] - a).normalized();
    for (const std::uint32_t corner : triangle)
      if (!((normals[corner] - face).norm() < 1e-3f)) return true;
  }
  return false;
}

}  // namespace sturm
