#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/images/image.h"
#include "io/specs/texture_wrap.h"
#include "pathtrace/materials/surface_model.h"

namespace sturm {

/// Where in a picture a texture coordinate of the mesh lies. v runs upwards from the picture's last row in both.
struct TextureMapping {
  Eigen::Matrix<float, 2, 3> picture_from_mesh = Eigen::Matrix<float, 2, 3>::Identity();  ///< (u, v) = M (u', v', 1)
  TextureWrap wrap_u = TextureWrap::Clamp, wrap_v = TextureWrap::Clamp;
};

/// How much of the light that comes to a surface meets it. What does not meet it goes on as if nothing were there.
struct Opacity {
  enum class Mode {
    opaque,  ///< all; nothing else counts
    mask,    ///< all where alpha reaches the cutoff, else none
    blend    ///< the share alpha of all rays
  };
  Mode mode = Mode::opaque;
  float factor = 1.0f;                   ///< 0 … 1; alpha is factor × texture × alpha of the vertex colours
  float cutoff = 0.5f;                   ///< of a mask
  std::shared_ptr<const Image> texture;  ///< 1 channel, linear; may be null
  TextureMapping mapping;
};

/// A surface. All but glass reflect on both sides. Meshes emit from the side their winding faces.
struct Material {
  std::string name;
  Eigen::Vector3f albedo{0.0f, 0.0f,
                         0.0f};  ///< what `surface` takes as its colour; of a conductor only for the albedo layer
  Eigen::Vector3f emission{0.0f, 0.0f, 0.0f};   ///< radiance, linear Rec. 709
  std::shared_ptr<const Image> albedo_texture;  ///< 3 channels, linear, multiplies `albedo`; may be null
  TextureMapping albedo_mapping;
  std::shared_ptr<const Image> emission_texture;  ///< 3 channels, linear, multiplies `emission`; may be null
  TextureMapping emission_mapping;
  bool emits_behind = false;   ///< meshes emit from both sides
  bool nearest_filter = true;  ///< of all textures; else bilinear
  Opacity opacity{};           ///< of meshes; spheres are opaque
  SurfaceModel surface;        ///< Lambert unless stated
};

/// Whether rays may pass meshes of it.
inline bool is_cut_out(const Material& material) {
  return material.opacity.mode != Opacity::Mode::opaque;
}

struct Mesh {
  std::string name;
  std::vector<Eigen::Vector3f> positions;               ///< [m], world
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from the side the normal points to
  std::vector<Eigen::Vector2f> texture_coordinates;     ///< one per position, or empty
  int material = 0;
  std::vector<Eigen::Vector3f> normals{};         ///< unit length, one per position, for smooth shading; or empty: flat
  std::vector<Eigen::Vector4f> vertex_colours{};  ///< one per position, or empty: linear Rec. 709, multiplies `albedo`,
                                                  ///< and alpha, multiplies the opacity; interpolated
  std::vector<Eigen::Vector2f> emission_coordinates{};  ///< of the emission texture, one per position; or empty: those
                                                        ///< of the other textures
  std::vector<std::string> also_named{};  ///< further names by which overrides find it: its object, its groups
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
