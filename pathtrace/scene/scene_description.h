#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/images/image.h"
#include "pathtrace/materials/surface_model.h"

namespace sturm {

/// A surface. Opaque ones reflect on both sides. Meshes emit from the side their winding faces.
struct Material {
  std::string name;
  Eigen::Vector3f albedo{0.0f, 0.0f,
                         0.0f};  ///< what `surface` takes as its colour; of a conductor only for the albedo layer
  Eigen::Vector3f emission{0.0f, 0.0f, 0.0f};  ///< radiance, linear Rec. 709
  std::shared_ptr<const Image>
      albedo_texture;           ///< 3 channels, linear, multiplies `albedo`; may be null. v runs upwards
  bool nearest_filter = true;   ///< else bilinear
  bool repeat_texture = false;  ///< else clamped
  SurfaceModel surface;         ///< Lambert unless stated
};

struct Mesh {
  std::string name;
  std::vector<Eigen::Vector3f> positions;               ///< [m], world
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from the side the normal points to
  std::vector<Eigen::Vector2f> texture_coordinates;     ///< one per position, or empty
  int material = 0;
  std::vector<Eigen::Vector3f> normals{};  ///< unit length, one per position, for smooth shading; or empty: flat
};

/// One of several copies of a prototype.
struct Instance {
  int prototype;                                    ///< index into SceneDescription::prototypes
  Eigen::Matrix<float, 3, 4> world_from_prototype;  ///< regular; a mirroring one keeps surfaces facing the way they do
};

struct Sphere {
  Eigen::Vector3f center;  ///< [m]
  float radius;            ///< [m]
  int material = 0;
};

/// Isotropic point light; not visible to camera rays.
struct PointLight {
  Eigen::Vector3f position;   ///< [m]
  Eigen::Vector3f intensity;  ///< radiant intensity, linear Rec. 709 [radiance · m²]
};

/// Light from infinity, the same wherever it is seen from.
struct Environment {
  Eigen::Vector3f radiance{1.0f, 1.0f, 1.0f};  ///< of all directions, or the factor of `map`; linear Rec. 709
  std::shared_ptr<const Image> map;            ///< 3 channels, see EnvironmentMap; may be null
  float rotation = 0.0f;                       ///< [rad], of the map about +y, to the right
};

/// Plain data; what `Scene` is built from.
struct SceneDescription {
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::vector<Sphere> spheres;
  std::vector<PointLight> lights;
  std::optional<Environment> environment{};
  std::vector<Mesh> prototypes{};  ///< seen only as instances; must not emit
  std::vector<Instance> instances{};
  std::vector<int> unseen_emitters{};  ///< never chosen as a light, by their numbers in the light set
                                       ///< (pathtrace/plan/unseen_emitters.h)
  std::vector<std::string> notes{};    ///< what the model files hold and this program leaves out
};

}  // namespace sturm
