#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/json.h"

namespace sturm {

enum class TextureEncoding { Linear, Srgb };
enum class TextureFilter { Nearest, Bilinear };

/// A model file (OBJ, glTF, …) and how to take it.
struct ModelSpec {
  std::filesystem::path file;  ///< absolute
  double scale = 1.0;          ///< metres per unit of the file
  TextureEncoding texture_encoding = TextureEncoding::Srgb;
  TextureFilter texture_filter = TextureFilter::Bilinear;
};

/// Lambertian material; linear Rec. 709.
struct MaterialSpec {
  std::string name;
  Eigen::Vector3d albedo{0.0, 0.0, 0.0};
  Eigen::Vector3d emission{0.0, 0.0, 0.0};  ///< radiance
};

struct MeshSpec {
  std::string name;
  int material = 0;                                     ///< index into SceneSpec::materials
  std::vector<Eigen::Vector3d> positions;               ///< [m], world
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< a quad a b c d has become a b c, a c d; winding as given
};

struct SphereSpec {
  Eigen::Vector3d center;  ///< [m]
  double radius = 0.0;     ///< [m]
  int material = 0;        ///< index into SceneSpec::materials
};

struct PointLightSpec {
  Eigen::Vector3d position;   ///< [m]
  Eigen::Vector3d intensity;  ///< radiant intensity, linear Rec. 709 [radiance · m²]
};

/// What is in the world: model files and things given in place. Nothing of it has been loaded.
struct SceneSpec {
  std::vector<ModelSpec> models;
  std::vector<MaterialSpec> materials;  ///< sorted by name
  std::vector<MeshSpec> meshes;
  std::vector<SphereSpec> spheres;
  std::vector<PointLightSpec> lights;
  std::vector<std::string> input_files;  ///< absolute paths: the scene's own file, if it has one, and the model files
};

/// Reads a scene object, or the path of a scene (.json) or model (any other) file relative to `where.file`.
/// Every named file must exist. Throws InputError.
SceneSpec read_scene(const Json& value, const Source& where);

}  // namespace sturm
