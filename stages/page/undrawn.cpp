#include "stages/page/undrawn.h"

#include <set>

namespace sturm {

namespace {

/// The materials that meshes and spheres have: others need no sentence.
std::set<int> used_materials(const SceneDescription& scene) {
  std::set<int> used;
  for (const Mesh& mesh : scene.meshes) used.insert(mesh.material);
  for (const Instance& instance : scene.instances)
    used.insert(scene.prototypes[static_cast<std::size_t>(instance.prototype)].material);
  for (const Sphere& sphere : scene.spheres) used.insert(sphere.material);
  return used;
}

template <class... Kinds>
bool is_one_of(const SurfaceModel& surface) {
  return (std::holds_alternative<Kinds>(surface) || ...);
}

void note_material(const Material& material, std::vector<std::string>& sentences) {
  const std::string name = "The material \"" + material.name + "\"";
  if (is_one_of<SeedDiffuse, SeedMetal, SeedDielectric, TintedMetal>(material.surface))
    sentences.push_back(name + " is drawn as a diffuse one of the same colour.");
  if (const auto* glass = std::get_if<Dielectric>(&material.surface); glass && glass->roughness > 0.0f)
    sentences.push_back(name + " is rough glass and is drawn smooth.");
  if (is_cut_out(material)) sentences.push_back(name + " lets rays pass in parts and is drawn opaque.");
}

}  // namespace

std::vector<std::string> undrawn(const SceneDescription& scene, const RenderSpec& spec) {
  std::vector<std::string> sentences;
  for (const int number : used_materials(scene))
    note_material(scene.materials[static_cast<std::size_t>(number)], sentences);
  bool apodized = spec.eye.eye.stiles_crawford_per_m2 > 0.0;
  if (spec.left) apodized |= spec.left->eye.stiles_crawford_per_m2 > 0.0;
  if (apodized) sentences.push_back("The pupil counts evenly: the Stiles\u2013Crawford effect is left out.");
  return sentences;
}

}  // namespace sturm
