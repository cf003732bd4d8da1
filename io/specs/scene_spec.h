#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"
#include "io/specs/material_spec.h"
#include "io/specs/texture_wrap.h"
#include "lensmodel/words.h"

namespace sturm {

enum class TextureEncoding { Linear, Srgb };
enum class TextureFilter { Nearest, Bilinear };

inline constexpr Words<TextureEncoding, 2> texture_encoding_words{
    {{TextureEncoding::Linear, "linear"}, {TextureEncoding::Srgb, "srgb"}}};
inline constexpr Words<TextureFilter, 2> texture_filter_words{
    {{TextureFilter::Nearest, "nearest"}, {TextureFilter::Bilinear, "bilinear"}}};

/// A material for one mesh of a model, in place of what the file says.
struct MaterialOverride {
  std::string mesh;  ///< name in the file
  MaterialSpec material;
};

/// A model file (OBJ, glTF, …) and how to take it.
struct ModelSpec {
  std::filesystem::path file;  ///< absolute
  double scale = 1.0;          ///< metres per unit of the file
  TextureEncoding texture_encoding = TextureEncoding::Srgb;
  TextureFilter texture_filter = TextureFilter::Bilinear;
  bool texture_filter_is_stated = false;      ///< else a file that has filters of its own may say "nearest"
  std::optional<TextureWrap> texture_wrap{};  ///< of both axes; none: as the file says
  std::vector<MaterialOverride> overrides{};
  double turn = 0.0;  ///< [rad] about +y through the file's origin, counter-clockwise seen from above; after scaling
  Eigen::Vector3d position{0.0, 0.0, 0.0};  ///< [m] where the file's origin is put, after turning
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

/// Light from infinity: a colour, or a latitude–longitude picture times that colour.
struct EnvironmentSpec {
  Eigen::Vector3d radiance{1.0, 1.0, 1.0};
  std::optional<std::filesystem::path> file;         ///< absolute
  double rotation = 0.0;                             ///< [rad], to the right
  std::optional<std::string> layer;                  ///< of an EXR file with several pictures
  TextureEncoding encoding = TextureEncoding::Srgb;  ///< of 8-bit and 16-bit values
  std::optional<double> clamp;                       ///< values are moved into 0 … this one; none: they must be there
};

/// What is in the world: model files and things given in place. Nothing of it has been loaded.
struct SceneSpec {
  std::vector<ModelSpec> models;
  std::vector<MaterialSpec> materials;  ///< sorted by name
  std::vector<MeshSpec> meshes;
  std::vector<SphereSpec> spheres;
  std::vector<PointLightSpec> lights;
  std::optional<EnvironmentSpec> environment;
  std::vector<std::string> input_files;  ///< absolute paths: the scene's own file, if it has one, the model files and
                                         ///< the environment's picture
};

/// Reads a scene object, or the path of a scene (.json) or model (any other) file relative to `where.file`.
/// Every named file must exist. Throws InputError.
SceneSpec read_scene(const Json& value, const Source& where);

}  // namespace sturm
