#include "stages/page/viewer_scene.h"

#include <nlohmann/json.hpp>

#include "stages/page/scene_arrays.h"
#include "stages/page/scene_geometry.h"
#include "stages/page/scene_textures.h"

namespace sturm {

namespace {

Json vector_json(const Eigen::Vector3f& v) {
  return {v.x(), v.y(), v.z()};
}

/// The kind of a surface and its numbers.
struct SurfaceJson {
  Json operator()(const Diffuse&) const { return {{"type", "diffuse"}}; }
  Json operator()(const Conductor& m) const {
    return {{"type", "conductor"},
            {"eta", vector_json(m.eta)},
            {"kappa", vector_json(m.kappa)},
            {"roughness", m.roughness}};
  }
  Json operator()(const Dielectric& m) const {
    return {{"type", "dielectric"}, {"index", m.index}, {"roughness", m.roughness}};
  }
  Json operator()(const Plastic& m) const {
    return {{"type", "plastic"}, {"index", m.index()}, {"roughness", m.roughness()}};
  }
  Json operator()(const SeedDiffuse&) const { return {{"type", "seed_diffuse"}}; }
  Json operator()(const SeedMetal& m) const { return {{"type", "seed_metal"}, {"alpha", m.alpha}}; }
  Json operator()(const SeedDielectric& m) const { return {{"type", "seed_dielectric"}, {"index", m.index}}; }
  Json operator()(const TintedMetal& m) const { return {{"type", "tinted_metal"}, {"roughness", m.roughness}}; }
};

class SceneWriter {
 public:
  std::string operator()(const SceneDescription& scene, const Scene& built) {
    Json header = {{"format", "sturm.viewer_scene/1"},
                   {"bounds_m", {{"lower", vector_json(built.lower())}, {"upper", vector_json(built.upper())}}},
                   {"offset_unit_m", built.offset_unit()}};
    add_geometry(scene, arrays_, header);
    header["spheres"] = Json::array();
    for (const Sphere& s : scene.spheres)
      header["spheres"].push_back(
          {{"center_m", vector_json(s.center)}, {"radius_m", s.radius}, {"material", s.material}});
    header["lights"] = Json::array();
    for (const PointLight& light : scene.lights)
      header["lights"].push_back(
          {{"position_m", vector_json(light.position)}, {"intensity", vector_json(light.intensity)}});
    header["materials"] = Json::array();
    for (const Material& material : scene.materials) header["materials"].push_back(material_json(material));
    header["environment"] = environment_json(scene.environment);
    header["textures"] = textures_.list();
    return scene_file(header, arrays_);
  }

 private:
  Json map_json(const std::shared_ptr<const Image>& picture, const TextureMapping& mapping) {
    if (!picture) return nullptr;
    Json matrix = Json::array();
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column < 3; ++column) matrix.push_back(mapping.picture_from_mesh(row, column));
    return {{"texture", textures_.number_of(picture)},
            {"matrix", std::move(matrix)},
            {"wrap", {texture_wrap_words.word_of(mapping.wrap_u), texture_wrap_words.word_of(mapping.wrap_v)}}};
  }

  Json opacity_json(const Opacity& opacity) {
    constexpr const char* modes[] = {"opaque", "mask", "blend"};
    return {{"mode", modes[static_cast<int>(opacity.mode)]},
            {"factor", opacity.factor},
            {"cutoff", opacity.cutoff},
            {"map", map_json(opacity.texture, opacity.mapping)}};
  }

  Json material_json(const Material& material) {
    Json result = std::visit(SurfaceJson{}, material.surface);
    result["name"] = material.name;
    result["albedo"] = vector_json(material.albedo);
    result["emission"] = vector_json(material.emission);
    result["emits_behind"] = material.emits_behind;
    result["nearest"] = material.nearest_filter;
    result["albedo_map"] = map_json(material.albedo_texture, material.albedo_mapping);
    result["emission_map"] = map_json(material.emission_texture, material.emission_mapping);
    result["opacity"] = opacity_json(material.opacity);
    return result;
  }

  Json environment_json(const std::optional<Environment>& environment) {
    if (!environment) return nullptr;
    return {{"radiance", vector_json(environment->radiance)},
            {"texture", textures_.number_of(environment->map)},
            {"rotation_rad", environment->rotation}};
  }

  SceneArrays arrays_;
  SceneTextures textures_{arrays_};
};

}  // namespace

std::string viewer_scene(const SceneDescription& description, const Scene& built) {
  return SceneWriter()(description, built);
}

}  // namespace sturm
