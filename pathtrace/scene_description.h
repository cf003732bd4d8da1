#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "io/image.h"

namespace sturm {

/// Lambertian surface, reflecting on both sides. Meshes emit from the side their winding faces.
struct Material {
  std::string name;
  Eigen::Vector3f albedo{0.0f, 0.0f, 0.0f};
  Eigen::Vector3f emission{0.0f, 0.0f, 0.0f};  ///< radiance, linear Rec. 709
  std::shared_ptr<const Image>
      albedo_texture;          ///< 3 channels, linear, multiplies `albedo`; may be null. v runs upwards, clamped at the border
  bool nearest_filter = true;  ///< else bilinear
};

struct Mesh {
  std::string name;
  std::vector<Eigen::Vector3f> positions;               ///< [m], world
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from the side the normal points to
  std::vector<Eigen::Vector2f> texture_coordinates;     ///< one per position, or empty
  int material = 0;
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

/// Plain data; what `Scene` is built from.
struct SceneDescription {
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::vector<Sphere> spheres;
  std::vector<PointLight> lights;
};

}  // namespace sturm
