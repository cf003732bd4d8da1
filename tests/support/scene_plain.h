#pragma once
#include <map>
#include <numbers>
#include <string>

#include "pathtrace/cameras/eye_camera.h"
#include "pathtrace/scene/scene_description.h"
#include "support/reference_file.h"

namespace sturm::testing {

inline Eigen::Vector3d vector3(const nlohmann::json& v) {
  return {v[0].get<double>(), v[1].get<double>(), v[2].get<double>()};
}

/// The two-box room of tests/reference/scene_plain/scene.json: 38 triangles, one emitting pair.
inline SceneDescription scene_plain() {
  const nlohmann::json file = reference_file("scene_plain/scene.json");
  SceneDescription description;
  std::map<std::string, int> materials;
  for (const auto& [name, m] : file["materials"].items()) {
    if (!m.contains("albedo")) continue;  // the chart's texture belongs to another scene
    materials[name] = static_cast<int>(description.materials.size());
    Material material;
    material.name = name;
    material.albedo = vector3(m["albedo"]).cast<float>();
    if (m.contains("emission")) material.emission = vector3(m["emission"]).cast<float>();
    description.materials.push_back(material);
  }
  for (const auto& m : file["meshes"]) {
    Mesh mesh;
    mesh.name = m["name"];
    mesh.material = materials.at(m["material"]);
    for (const auto& p : m["positions"]) mesh.positions.push_back(vector3(p).cast<float>());
    for (const auto& f : m["faces"])
      mesh.triangles.push_back({f[0].get<std::uint32_t>(), f[1].get<std::uint32_t>(), f[2].get<std::uint32_t>()});
    description.meshes.push_back(mesh);
  }
  return description;
}

/// Its camera.
inline CameraPose scene_plain_pose() {
  const nlohmann::json camera = reference_file("scene_plain/scene.json")["camera"];
  CameraPose pose;
  pose.position = vector3(camera["position"]);
  pose.look_at = vector3(camera["look_at"]);
  pose.up = vector3(camera["up"]);
  pose.vertical_field = camera["vfov_deg"].get<double>() * std::numbers::pi / 180.0;
  pose.width = camera["resolution"][0];
  pose.height = camera["resolution"][1];
  return pose;
}

/// A perfect thin lens of the given radius focused on the plane at `focus_distance` [m]: an emmetrope who accommodates.
inline EyeRays<float> focused_lens(double radius, double focus_distance) {
  return {RayModel::power_matrix, Eye::with({}, 2.0 * radius), 1.0 / focus_distance};
}

}  // namespace sturm::testing
