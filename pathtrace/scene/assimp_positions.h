#pragma once
#include <assimp/scene.h>

#include <Eigen/Core>
#include <assimp/Importer.hpp>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sturm {

/// Positions of meshes that Assimp has read. It keeps them in single precision, which is too coarse for a model that
/// lies far from its origin; then they are read in double beside it, where the file states them so.
class AssimpPositions {
 public:
  /// Whether the shape of some mesh has suffered (pathtrace/scene/lost_precision.h).
  static bool are_far_from_the_origin(const aiScene& scene);

  /// Reads the positions of COLLADA files and of STL files that are text. Returns the scene to go on with, the same or
  /// read anew by the importer (null where that fails); of files that state nothing better, positions stay as they are.
  const aiScene* read(Assimp::Importer& importer, const aiScene& scene, const std::filesystem::path& file,
                      unsigned steps);

  /// In units of the file, as the mesh has it.
  Eigen::Vector3d position(const aiMesh& mesh, unsigned vertex) const;

  /// The largest coordinate at which something about the mesh was rounded to single precision: its positions, or the
  /// matrix of its node where that turns, stretches or moves it.
  double largest_rounded(const aiMesh& mesh, const Eigen::Matrix4d& file_from_node) const;

 private:
  void take_stated(const aiScene& scene, const std::vector<Eigen::Vector3d>& stated);

  std::map<const aiMesh*, std::vector<Eigen::Vector3d>> stated_;
  std::map<std::string, Eigen::Vector3d> offsets_;  // to be added, by names of meshes
};

}  // namespace sturm
