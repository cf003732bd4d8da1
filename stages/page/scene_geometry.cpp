#include "stages/page/scene_geometry.h"

#include <Eigen/LU>
#include <nlohmann/json.hpp>

namespace sturm {

namespace {

/// Vertices of all meshes one behind the other. What some mesh has, all get: what stands for "not there" is in
/// docs/formats/viewer_scene.md.
class Geometry {
 public:
  explicit Geometry(const SceneDescription& scene) {
    for (const auto* meshes : {&scene.meshes, &scene.prototypes})
      for (const Mesh& mesh : *meshes) {
        smooth_ |= !mesh.normals.empty();
        textured_ |= !mesh.texture_coordinates.empty() || !mesh.emission_coordinates.empty();
        lit_elsewhere_ |= !mesh.emission_coordinates.empty();
        coloured_ |= !mesh.vertex_colours.empty();
      }
  }

  void add(const Mesh& mesh) {
    begin(mesh);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      append(positions_, mesh.positions[v]);
      if (smooth_) append(normals_, mesh.normals.empty() ? Eigen::Vector3f(Eigen::Vector3f::Zero()) : mesh.normals[v]);
      add_attributes(mesh, v);
    }
  }

  void add(const Mesh& prototype, const Eigen::Matrix<float, 3, 4>& world) {
    begin(prototype, world.leftCols<3>().determinant() < 0.0f);
    const Eigen::Matrix3f turned = world.leftCols<3>().inverse().transpose();
    for (std::size_t v = 0; v < prototype.positions.size(); ++v) {
      append(positions_, Eigen::Vector3f(world * prototype.positions[v].homogeneous()));
      if (smooth_)
        append(normals_, prototype.normals.empty() ? Eigen::Vector3f(Eigen::Vector3f::Zero())
                                                   : Eigen::Vector3f((turned * prototype.normals[v]).normalized()));
      add_attributes(prototype, v);
    }
  }

  void write(SceneArrays& arrays, Json& header) const {
    header["positions"] = arrays.add(positions_, 3);
    header["normals"] = smooth_ ? arrays.add(normals_, 3) : Json(nullptr);
    header["texture_coordinates"] = textured_ ? arrays.add(coordinates_, 2) : Json(nullptr);
    header["emission_coordinates"] = lit_elsewhere_ ? arrays.add(emission_coordinates_, 2) : Json(nullptr);
    header["colours"] = coloured_ ? arrays.add(colours_, 4) : Json(nullptr);
    header["triangles"] = arrays.add(triangles_, 3);
    header["meshes"] = meshes_;
  }

 private:
  template <class Vector>
  static void append(std::vector<float>& numbers, const Vector& v) {
    numbers.insert(numbers.end(), v.data(), v.data() + v.size());
  }

  /// Triangles of a mirrored mesh turn round, so that they face the way they did.
  void begin(const Mesh& mesh, bool mirrored = false) {
    const auto first = static_cast<std::uint32_t>(positions_.size() / 3);
    meshes_.push_back({{"name", mesh.name},
                       {"material", mesh.material},
                       {"first_triangle", triangles_.size() / 3},
                       {"triangle_count", mesh.triangles.size()}});
    for (const auto& t : mesh.triangles)
      triangles_.insert(triangles_.end(), {first + t[0], first + t[mirrored ? 2 : 1], first + t[mirrored ? 1 : 2]});
  }

  void add_attributes(const Mesh& mesh, std::size_t v) {
    const Eigen::Vector2f nowhere(0.0f, 0.0f);
    const Eigen::Vector2f place = mesh.texture_coordinates.empty() ? nowhere : mesh.texture_coordinates[v];
    if (textured_) append(coordinates_, place);
    if (lit_elsewhere_)
      append(emission_coordinates_, mesh.emission_coordinates.empty() ? place : mesh.emission_coordinates[v]);
    if (coloured_)
      append(colours_, mesh.vertex_colours.empty() ? Eigen::Vector4f(Eigen::Vector4f::Ones()) : mesh.vertex_colours[v]);
  }

  bool smooth_ = false, textured_ = false, lit_elsewhere_ = false, coloured_ = false;
  std::vector<float> positions_, normals_, coordinates_, emission_coordinates_, colours_;
  std::vector<std::uint32_t> triangles_;
  Json meshes_ = Json::array();
};

}  // namespace

void add_geometry(const SceneDescription& scene, SceneArrays& arrays, Json& header) {
  Geometry geometry(scene);
  for (const Mesh& mesh : scene.meshes) geometry.add(mesh);
  for (const Instance& instance : scene.instances)
    geometry.add(scene.prototypes[static_cast<std::size_t>(instance.prototype)], instance.world_from_prototype);
  geometry.write(arrays, header);
}

}  // namespace sturm
