#pragma once
#include <Eigen/Core>
#include <initializer_list>

#include "io/images/image.h"
#include "pathtrace/cameras/eye_camera.h"
#include "pathtrace/scene/scene_description.h"

namespace sturm::testing {

/// A parallelogram; its normal, from which it emits, is edge1 × edge2.
inline Mesh parallelogram(const Eigen::Vector3f& corner, const Eigen::Vector3f& edge1, const Eigen::Vector3f& edge2,
                          int material) {
  Mesh mesh;
  mesh.name = "parallelogram";
  mesh.positions = {corner, corner + edge1, corner + edge1 + edge2, corner + edge2};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.material = material;
  return mesh;
}

/// The six faces of the cube |x|, |y|, |z| ≤ half, normals inwards.
inline std::vector<Mesh> room(float half, int material) {
  const Eigen::Vector3f low(-half, -half, -half), high(half, half, half), x(2 * half, 0, 0), y(0, 2 * half, 0),
      z(0, 0, 2 * half);
  return {parallelogram(low, x, y, material),    parallelogram(low, y, z, material),
          parallelogram(low, z, x, material),    parallelogram(high, -y, -x, material),
          parallelogram(high, -z, -y, material), parallelogram(high, -x, -z, material)};
}

inline Material lambertian(const Eigen::Vector3f& albedo, const Eigen::Vector3f& emission = Eigen::Vector3f::Zero()) {
  Material material;
  material.albedo = albedo;
  material.emission = emission;
  return material;
}

inline EyeRays<float> pinhole_rays() {
  return {RayModel::pinhole, Eye::with({}, 0.0), 0.0};
}

/// A camera of one or a few pixels with a field so narrow that it sees one point.
inline EyeCamera spot_meter(const Eigen::Vector3d& position, const Eigen::Vector3d& look_at) {
  CameraPose pose;
  pose.position = position;
  pose.look_at = look_at;
  pose.up = {0.0, 1.0, 0.0};
  pose.vertical_field = 1e-5;
  pose.width = pose.height = 1;
  return {pose, pinhole_rays()};
}

/// Mean over all pixels of one channel, summed in double.
inline double image_mean(const Image& image, int channel) {
  double sum = 0.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) sum += static_cast<double>(image.at(x, y)[channel]);
  return sum / (static_cast<double>(image.width) * image.height);
}

}  // namespace sturm::testing
