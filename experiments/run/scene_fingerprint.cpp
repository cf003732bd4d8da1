#include "experiments/run/scene_fingerprint.h"

#include <type_traits>
#include <variant>

#include "io/files/sha256.h"

namespace sturm {

namespace {

/// Hash of the bytes of an array of plain numbers.
template <class T>
std::string hash_of(const std::vector<T>& values) {
  return sha256({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

void add(std::string& facts, const Eigen::Vector3f& v) {
  facts.append(reinterpret_cast<const char*>(v.data()), 3 * sizeof(float));
}

template <class T>
void add_number(std::string& facts, T value) {
  static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
  facts.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void add_mapping(std::string& facts, const TextureMapping& mapping) {
  for (const float value : mapping.picture_from_mesh.reshaped()) add_number(facts, value);
  add_number(facts, mapping.wrap_u);
  add_number(facts, mapping.wrap_v);
}

/// A surface model: nothing but floats, so that there is no padding among its bytes.
template <class Model>
void add_bytes(std::string& facts, const Model& model) {
  static_assert(std::is_empty_v<Model> || sizeof(Model) % sizeof(float) == 0);
  if constexpr (!std::is_empty_v<Model>) facts.append(reinterpret_cast<const char*>(&model), sizeof model);
}

}  // namespace

std::string scene_fingerprint(const SceneDescription& scene) {
  std::string facts;
  for (const Material& m : scene.materials) {
    add(facts, m.albedo);
    add(facts, m.emission);
    add_number(facts, m.nearest_filter);
    add_number(facts, m.emits_behind);
    add_mapping(facts, m.albedo_mapping);
    add_mapping(facts, m.emission_mapping);
    add_number(facts, m.opacity.mode);
    add_number(facts, m.opacity.factor);
    add_number(facts, m.opacity.cutoff);
    add_mapping(facts, m.opacity.mapping);
    add_number(facts, m.surface.index());
    std::visit([&](const auto& surface) { add_bytes(facts, surface); }, m.surface);
    for (const auto& texture : {m.albedo_texture, m.emission_texture, m.opacity.texture})
      facts += texture ? std::to_string(texture->width) + hash_of(texture->pixels) : "none";
  }
  for (const std::vector<Mesh>* meshes : {&scene.meshes, &scene.prototypes})
    for (const Mesh& m : *meshes) {
      facts += hash_of(m.positions) + hash_of(m.triangles) + hash_of(m.texture_coordinates) + hash_of(m.normals) +
               hash_of(m.vertex_colours) + hash_of(m.emission_coordinates);
      add_number(facts, m.material);
    }
  for (const Instance& i : scene.instances) {
    add_number(facts, i.prototype);
    facts.append(reinterpret_cast<const char*>(i.world_from_prototype.data()), 12 * sizeof(float));
  }
  if (scene.environment) {
    add(facts, scene.environment->radiance);
    add_number(facts, scene.environment->rotation);
    if (scene.environment->map)
      facts += std::to_string(scene.environment->map->width) + hash_of(scene.environment->map->pixels);
  }
  for (const Sphere& s : scene.spheres) {
    add(facts, s.center);
    add_number(facts, s.radius);
    add_number(facts, s.material);
  }
  for (const PointLight& l : scene.lights) {
    add(facts, l.position);
    add(facts, l.intensity);
  }
  return sha256(facts);
}

}  // namespace sturm
