#include "app/experiment/scene_fingerprint.h"

#include <type_traits>

#include "io/sha256.h"

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
  static_assert(std::is_arithmetic_v<T>);
  facts.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

std::string scene_fingerprint(const SceneDescription& scene) {
  std::string facts;
  for (const Material& m : scene.materials) {
    add(facts, m.albedo);
    add(facts, m.emission);
    add_number(facts, m.nearest_filter);
    if (m.albedo_texture) facts += std::to_string(m.albedo_texture->width) + hash_of(m.albedo_texture->pixels);
  }
  for (const Mesh& m : scene.meshes) {
    facts += hash_of(m.positions) + hash_of(m.triangles) + hash_of(m.texture_coordinates);
    add_number(facts, m.material);
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
