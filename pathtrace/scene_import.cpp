#include "pathtrace/scene_import.h"

#include <iterator>
#include <utility>

#include "pathtrace/assimp_import.h"

namespace sturm {
namespace {

template <class T>
void append(std::vector<T>& to, std::vector<T>&& from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

void append_model(SceneDescription& scene, SceneDescription&& model) {
  const int first_material = static_cast<int>(scene.materials.size());
  for (Mesh& mesh : model.meshes) mesh.material += first_material;
  append(scene.materials, std::move(model.materials));
  append(scene.meshes, std::move(model.meshes));
}

}  // namespace

SceneDescription build_scene(const SceneSpec& spec) {
  SceneDescription scene;
  for (const MaterialSpec& m : spec.materials) {
    Material material;
    material.name = m.name;
    material.albedo = m.albedo.cast<float>();
    material.emission = m.emission.cast<float>();
    scene.materials.push_back(std::move(material));
  }
  for (const MeshSpec& m : spec.meshes) {
    Mesh mesh;
    mesh.name = m.name;
    mesh.material = m.material;
    mesh.triangles = m.triangles;
    for (const Eigen::Vector3d& p : m.positions) mesh.positions.push_back(p.cast<float>());
    scene.meshes.push_back(std::move(mesh));
  }
  for (const SphereSpec& s : spec.spheres) scene.spheres.push_back({s.center.cast<float>(), static_cast<float>(s.radius), s.material});
  for (const PointLightSpec& l : spec.lights) scene.lights.push_back({l.position.cast<float>(), l.intensity.cast<float>()});
  for (const ModelSpec& model : spec.models)
    append_model(scene, import_model(model.file, model.scale, model.texture_encoding, model.texture_filter));
  return scene;
}

}  // namespace sturm
