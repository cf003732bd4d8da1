#include "pathtrace/scene/assimp_positions.h"

#include <algorithm>
#include <cmath>

#include "pathtrace/scene/collada_shift.h"
#include "pathtrace/scene/lost_precision.h"
#include "pathtrace/scene/stated_positions.h"

namespace sturm {
namespace {

Eigen::Vector3d rounded_position(const aiMesh& mesh, unsigned vertex) {
  const aiVector3D& p = mesh.mVertices[vertex];
  return {p.x, p.y, p.z};
}

bool has_suffered(const aiMesh& source) {
  Mesh mesh;
  for (unsigned i = 0; i < source.mNumVertices; ++i)
    mesh.positions.push_back(rounded_position(source, i).cast<float>());
  for (unsigned f = 0; f < source.mNumFaces; ++f) {
    const aiFace& face = source.mFaces[f];
    if (face.mNumIndices == 3 && std::max({face.mIndices[0], face.mIndices[1], face.mIndices[2]}) < source.mNumVertices)
      mesh.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
  }
  return !lost_precision(mesh, largest_coordinate_of(mesh)).empty();
}

}  // namespace

bool AssimpPositions::are_far_from_the_origin(const aiScene& scene) {
  return std::any_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes, [](const aiMesh* m) { return has_suffered(*m); });
}

const aiScene* AssimpPositions::read(Assimp::Importer& importer, const aiScene& scene,
                                     const std::filesystem::path& file, unsigned steps) {
  if (ShiftedCollada shifted = shifted_collada(file); !shifted.offsets.empty()) {
    offsets_ = std::move(shifted.offsets);
    return importer.ReadFileFromMemory(shifted.text.data(), shifted.text.size(), steps, "dae");
  }
  take_stated(scene, stated_positions(file));
  return &scene;
}

void AssimpPositions::take_stated(const aiScene& scene, const std::vector<Eigen::Vector3d>& stated) {
  std::size_t next = 0;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[i];
    std::vector<Eigen::Vector3d>& positions = stated_[&mesh];
    for (unsigned k = 0; k < mesh.mNumVertices && next < stated.size(); ++k, ++next) {
      if ((rounded_position(mesh, k) - stated[next]).norm() > 1e-6 * stated[next].norm()) break;  // another order
      positions.push_back(stated[next]);
    }
    if (positions.size() != mesh.mNumVertices) return stated_.clear();
  }
}

Eigen::Vector3d AssimpPositions::position(const aiMesh& mesh, unsigned vertex) const {
  if (const auto at = stated_.find(&mesh); at != stated_.end()) return at->second[vertex];
  const Eigen::Vector3d rounded = rounded_position(mesh, vertex);
  const auto offset = offsets_.find(mesh.mName.C_Str());
  return offset == offsets_.end() ? rounded : rounded + offset->second;
}

double AssimpPositions::largest_rounded(const aiMesh& mesh, const Eigen::Matrix4d& file_from_node) const {
  const Eigen::Matrix3d linear = file_from_node.topLeftCorner<3, 3>();
  const bool linear_is_exact = std::all_of(linear.data(), linear.data() + 9,
                                           [](double entry) { return entry == 0.0 || std::abs(entry) == 1.0; });
  double largest = file_from_node.topRightCorner<3, 1>().cwiseAbs().maxCoeff();
  if (linear_is_exact && stated_.contains(&mesh)) return largest;
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const Eigen::Vector3d p = linear_is_exact ? rounded_position(mesh, i) : position(mesh, i);
    largest = std::max(largest, (linear * p).cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace sturm
