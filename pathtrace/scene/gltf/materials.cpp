#include "pathtrace/scene/gltf/materials.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "pathtrace/materials/fresnel.h"
#include "pathtrace/scene/gltf/extensions.h"
#include "pathtrace/scene/gltf/members.h"
#include "pathtrace/scene/gltf_surface.h"

namespace sturm::gltf {

namespace {

const Json no_members = Json::object();

std::string called(const Material& material) {
  return "material \"" + material.name + "\"";
}

/// Red, green, blue (and alpha) of a colour within 0 … 1.
Eigen::Vector4f colour(const Json& parent, const char* key, const Source& where, const std::string& of) {
  const std::vector<double> values = reals(parent, key, where, {1.0, 1.0, 1.0, 1.0});
  for (const double value : values)
    if (!(value >= 0.0 && value <= 1.0)) (where / key).fail(parent[key], "reflectances from 0 to 1 (" + of + ")");
  return Eigen::Vector4d(values.data()).cast<float>();
}

double factor(const Json& parent, const char* key, const Source& where, double otherwise, const std::string& of) {
  const double value = real(parent, key, where, otherwise);
  if (!(value >= 0.0 && value <= 1.0)) (where / key).fail(parent[key], "a factor from 0 to 1 (" + of + ")");
  return value;
}

bool has_light(const Image& picture) {
  return std::any_of(picture.pixels.begin(), picture.pixels.end(), [](float value) { return value > 0.0f; });
}

}  // namespace

const PlacedMaterial& Materials::placed(const MaterialUse& use) {
  const auto at = placed_.find(use.key());
  return at != placed_.end() ? at->second : placed_.emplace(use.key(), build(use)).first->second;
}

PlacedMaterial Materials::build(const MaterialUse& use) {
  const Json& source = use.material ? document_.json()["materials"][*use.material] : no_members;
  const Source where = use.material ? document_.root() / "materials" / *use.material : document_.root();
  if (!source.is_object()) where.fail(source, "an object");
  PlacedMaterial result;
  Material material;
  material.name = text(source, "name", where, "");
  material.nearest_filter = spec_.texture_filter == TextureFilter::Nearest;
  if (const Json* glossy = extension(source, "KHR_materials_pbrSpecularGlossiness"))
    take_base(*glossy, where / "extensions" / "KHR_materials_pbrSpecularGlossiness", "diffuseFactor", "diffuseTexture",
              material, result);
  else
    take_base(object(source, "pbrMetallicRoughness", where), where / "pbrMetallicRoughness", "baseColorFactor",
              "baseColorTexture", material, result);
  take_opacity(source, where, use, material);
  take_emission(source, where, material, result);
  take_surface(source, where, use.coloured, material);
  result.index = static_cast<int>(scene_.materials.size());
  scene_.materials.push_back(std::move(material));
  return result;
}

void Materials::take_base(const Json& pbr, const Source& where, const char* colour_key, const char* picture,
                          Material& material, PlacedMaterial& result) {
  const Eigen::Vector4f base = colour(pbr, colour_key, where, called(material));
  material.albedo = base.head<3>();
  material.opacity.factor = base.w();
  const auto texture = textures_.read(pbr, picture, where, spec_.texture_encoding, called(material));
  if (!texture) return;
  material.albedo_texture = texture->colours;
  material.albedo_mapping = material.opacity.mapping = texture->mapping;
  material.opacity.texture = texture->alpha;
  material.nearest_filter = texture->nearest;
  result.coordinates = texture->set;
}

void Materials::take_opacity(const Json& source, const Source& where, const MaterialUse& use, Material& material) {
  Opacity& opacity = material.opacity;
  const std::string mode = text(source, "alphaMode", where, "OPAQUE");
  const bool solid = opacity.factor >= 1.0f && !opacity.texture && !use.translucent;  // alpha is 1 everywhere
  opacity.cutoff = static_cast<float>(real(source, "alphaCutoff", where, 0.5));
  if (mode == "MASK") {
    if (!(opacity.cutoff >= 0.0f)) (where / "alphaCutoff").fail(source["alphaCutoff"], "a number of at least 0");
    if (!solid || opacity.cutoff > 1.0f) opacity.mode = Opacity::Mode::mask;
  } else if (mode == "BLEND") {
    if (solid) return;
    opacity.mode = Opacity::Mode::blend;
    note(called(material) + ": alpha is blended by chance: the share alpha of all rays meets it, the others pass");
  } else if (mode != "OPAQUE") {
    (where / "alphaMode").fail(source["alphaMode"], "\"OPAQUE\", \"MASK\" or \"BLEND\"");
  }
}

void Materials::take_emission(const Json& source, const Source& where, Material& material, PlacedMaterial& result) {
  double strength = 1.0;
  if (const Json* extended = extension(source, "KHR_materials_emissive_strength"))
    strength = real(*extended, "emissiveStrength", where / "extensions" / "KHR_materials_emissive_strength", strength);
  const std::vector<double> factors = reals(source, "emissiveFactor", where, {0.0, 0.0, 0.0});
  for (const double value : factors) {
    const auto radiance = static_cast<float>(strength * value);
    if (!(radiance >= 0.0f && std::isfinite(radiance)))
      (where / "emissiveFactor")
          .fail(source.value("emissiveFactor", no_members), "finite radiances of at least 0, times the strength " +
                                                                std::to_string(strength) + " (" + called(material) +
                                                                ", emission)");
  }
  material.emission = (strength * Eigen::Vector3d(factors.data())).cast<float>();
  material.emits_behind = flag(source, "doubleSided", where, false);
  if (!(material.emission.maxCoeff() > 0.0f)) return;
  const auto texture = textures_.read(source, "emissiveTexture", where, spec_.texture_encoding, called(material));
  if (!texture) return;
  if (!has_light(*texture->colours)) {
    material.emission.setZero();
    return;
  }
  material.emission_texture = texture->colours;
  material.emission_mapping = texture->mapping;
  if (!material.albedo_texture) material.nearest_filter = texture->nearest;
  result.emission_coordinates = texture->set;
}

void Materials::take_surface(const Json& source, const Source& where, bool coloured, Material& material) {
  GltfFactors factors;
  const Json& pbr = object(source, "pbrMetallicRoughness", where);
  const Source place = where / "pbrMetallicRoughness";
  factors.metallic = static_cast<float>(factor(pbr, "metallicFactor", place, 1.0, called(material)));
  factors.roughness = static_cast<float>(factor(pbr, "roughnessFactor", place, 1.0, called(material)));
  if (const Json* refraction = extension(source, "KHR_materials_ior")) {
    const Source ior_place = where / "extensions" / "KHR_materials_ior";
    factors.index = static_cast<float>(real(*refraction, "ior", ior_place, 1.5));
    if (!(factors.index >= 1.0f && factors.index <= 4.0f))
      (ior_place / "ior").fail((*refraction)["ior"], "from 1 to 4 (" + called(material) + ", index)");
  }
  if (const auto texture =
          textures_.read(pbr, "metallicRoughnessTexture", place, TextureEncoding::Linear, called(material))) {
    const Eigen::Vector3f mean = mean_of(*texture->colours);
    factors.roughness *= mean.y();
    factors.metallic *= mean.z();
    note(called(material) + ": the mean of its metallic-roughness texture is taken");
  }
  if (const Json* glossy = extension(source, "KHR_materials_pbrSpecularGlossiness")) {
    factors.metallic = 0.0f;
    factors.roughness = static_cast<float>(1.0 - factor(*glossy, "glossinessFactor",
                                                        where / "extensions" / "KHR_materials_pbrSpecularGlossiness",
                                                        1.0, called(material)));
  }
  if (extension(source, "KHR_materials_unlit")) factors = {.metallic = 0.0f, .roughness = 1.0f};
  factors.base_colour = material.albedo;
  if (!(factors.index > 1.0f)) factors.roughness = 1.0f;  // a coat of index 1 reflects nothing
  const GltfSurface found = gltf_surface(factors);
  material.surface = found.surface;
  note_what_is_left_out(source, material, found.left_out);
  const auto* metal = std::get_if<Conductor>(&found.surface);
  if (!metal) return;
  if (coloured || material.albedo_texture)
    material.surface = TintedMetal{metal->roughness};
  else  // the albedo layer shows a metal by its colour seen straight on
    material.albedo = fresnel_conductor(1.0f, metal->eta, metal->kappa);
}

void Materials::note_what_is_left_out(const Json& source, const Material& material, const std::string& more) {
  std::vector<std::string> parts = extensions_left_out(source);
  for (const auto& [key, name] : {std::pair{"normalTexture", "normal map"}, {"occlusionTexture", "occlusion texture"}})
    if (source.contains(key)) parts.emplace_back(name);
  if (const Json* glossy = extension(source, "KHR_materials_pbrSpecularGlossiness"))
    if (glossy->contains("specularGlossinessTexture")) parts.emplace_back("specular-glossiness texture");
  if (!more.empty()) parts.push_back(more);
  std::string all;
  for (const std::string& part : parts) all += (all.empty() ? "" : ", ") + part;
  if (!all.empty()) note(called(material) + " is taken without its " + all);
}

void Materials::note(const std::string& text) {
  const std::string full = document_.file().filename().string() + ": " + text;
  if (std::find(scene_.notes.begin(), scene_.notes.end(), full) == scene_.notes.end()) scene_.notes.push_back(full);
}

}  // namespace sturm::gltf
