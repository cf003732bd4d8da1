#include "pathtrace/scene/vertex_normals.h"

#include <Eigen/Geometry>
#include <cmath>

namespace sturm {

std::vector<Eigen::Vector3f> normals_that_bend(const std::vector<Eigen::Vector3d>& normals, const Mesh& mesh) {
  std::vector<Eigen::Vector3f> unit;
  unit.reserve(normals.size());
  for (const Eigen::Vector3d& normal : normals) {
    const double length = normal.norm();
    if (!(length > 0.0 && std::isfinite(length))) return {};
    unit.push_back((normal / length).cast<float>());
  }
  if (unit.empty()) return {};
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3f& a = mesh.positions[triangle[0]];
    const Eigen::Vector3f face = (mesh.positions[triangle[1]] - a).cross(mesh.positions[triangle[2]] - a).normalized();
    for (const std::uint32_t corner : triangle)
      if (!((unit[corner] - face).norm() < 1e-3f)) return unit;
  }
  return {};
}

}  // namespace sturm
