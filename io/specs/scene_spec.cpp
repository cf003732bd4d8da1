#include "io/specs/scene_spec.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "io/files/error.h"
#include "io/files/lower_case.h"
#include "io/json/named_file.h"
#include "io/json/suggest.h"
#include "io/json/values.h"
#include "io/specs/words.h"

namespace sturm {

namespace {

constexpr double largest_half = 65504.0;  // what an EXR of 16 bits can hold

const Json& member(const Json& object, const char* key) {
  static const Json nothing = Json::array();
  const auto at = object.find(key);
  return at == object.end() ? nothing : *at;
}

std::vector<MaterialSpec> read_materials(const Json& object, const Source& where) {
  std::vector<MaterialSpec> materials;
  for (const auto& [name, value] : object.items()) materials.push_back(read_material(name, value, where / name));
  return materials;
}

int read_material_name(const Json& value, const Source& where, const std::vector<MaterialSpec>& materials) {
  std::vector<std::string> names;
  for (const MaterialSpec& material : materials) {
    if (material.name == value) return static_cast<int>(names.size());
    names.push_back(material.name);
  }
  throw InputError(where.file, where.pointer, compact(value) + did_you_mean(value.get<std::string>(), names),
                   one_of(names) + " (materials of this scene)");
}

/// Overrides name a material of the scene, or hold one.
std::vector<MaterialOverride> read_overrides(const Json& list, const Source& where,
                                             const std::vector<MaterialSpec>& materials) {
  std::vector<MaterialOverride> overrides;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string mesh = list[i]["mesh"].get<std::string>();
    const Json& material = list[i]["material"];
    const Source place = where / i / "material";
    if (std::any_of(overrides.begin(), overrides.end(), [&](const MaterialOverride& o) { return o.mesh == mesh; }))
      (where / i / "mesh").fail(list[i]["mesh"], "one override for a mesh");
    overrides.push_back({mesh, material.is_string()
                                   ? materials[static_cast<std::size_t>(read_material_name(material, place, materials))]
                                   : read_material("override of " + mesh, material, place)});
  }
  return overrides;
}

/// Throws for a USD scene, which nothing that Sturm is built with reads.
void refuse_usd(const std::filesystem::path& file, const Json& value, const Source& where) {
  const std::string extension = lower_case(file.extension().string());
  for (const char* usd : {".usd", ".usda", ".usdc", ".usdz"})
    if (extension == usd)
      where.fail(value, "OBJ, glTF or another model file; a USD scene becomes a .glb by scripts/convert_usd SCENE" +
                            extension + " SCENE.glb");
}

ModelSpec read_model(const Json& value, const Source& where, const std::vector<MaterialSpec>& materials) {
  ModelSpec model;
  model.file = existing_file(value["file"], where / "file", "the path of a model file");
  refuse_usd(model.file, value["file"], where / "file");
  model.scale = value.value("scale", model.scale);
  model.turn = value.value("turn_deg", 0.0) * std::numbers::pi / 180.0;
  if (value.contains("position_m")) model.position = read_vector3(value["position_m"]);
  model.texture_encoding = word_or(value, "texture_encoding", model.texture_encoding, where, texture_encoding_words);
  model.texture_filter = word_or(value, "texture_filter", model.texture_filter, where, texture_filter_words);
  model.texture_filter_is_stated = value.contains("texture_filter");
  if (value.contains("texture_wrap"))
    model.texture_wrap = word_or(value, "texture_wrap", TextureWrap::Clamp, where, texture_wrap_words);
  model.overrides = read_overrides(member(value, "overrides"), where / "overrides", materials);
  return model;
}

EnvironmentSpec read_environment(const Json& value, const Source& where) {
  EnvironmentSpec environment;
  if (value.contains("radiance")) environment.radiance = read_vector3(value["radiance"]);
  if (value.contains("file"))
    environment.file = existing_file(value["file"], where / "file", "the path of a latitude-longitude picture");
  if (!environment.file && value.value("rotation_deg", 0.0) != 0.0)
    (where / "rotation_deg").fail(value["rotation_deg"], "a \"file\" that it turns");
  environment.rotation = value.value("rotation_deg", 0.0) * std::numbers::pi / 180.0;
  if (value.contains("layer")) environment.layer = value["layer"].get<std::string>();
  environment.encoding = word_or(value, "encoding", environment.encoding, where, texture_encoding_words);
  if (const auto clamp = value.find("clamp"); clamp != value.end() && *clamp != false)
    environment.clamp = clamp->is_boolean() ? largest_half : clamp->get<double>();
  return environment;
}

MeshSpec read_mesh(const Json& value, const Source& where, const std::vector<MaterialSpec>& materials) {
  MeshSpec mesh;
  mesh.name = value.value("name", "");
  mesh.material = read_material_name(value["material"], where / "material", materials);
  for (const Json& position : value["positions_m"]) mesh.positions.push_back(read_vector3(position));
  const Json& faces = value["faces"];
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::array<std::uint32_t, 4> corners{};
    for (std::size_t c = 0; c < faces[f].size(); ++c) {
      const auto index = faces[f][c].get<std::uint64_t>();
      if (index >= mesh.positions.size())
        (where / "faces" / f / c)
            .fail(faces[f][c], "the number of a vertex, from 0 to " + std::to_string(mesh.positions.size() - 1));
      corners[c] = static_cast<std::uint32_t>(index);
    }
    mesh.triangles.push_back({corners[0], corners[1], corners[2]});
    if (faces[f].size() == 4) mesh.triangles.push_back({corners[0], corners[2], corners[3]});
  }
  return mesh;
}

}  // namespace

SceneSpec read_scene(const Json& value, const Source& where) {
  SceneSpec scene;
  if (value.is_string()) {
    const std::filesystem::path file = existing_document(value, where, "scene", "the path of a scene or model file");
    if (file.extension() != ".json") {
      refuse_usd(file, value, where);
      scene.models.push_back({.file = file});
      scene.input_files.push_back(file.string());
      return scene;
    }
    scene = read_scene(load_named_document(value, where, "scene"), {file.string(), ""});
    scene.input_files.insert(scene.input_files.begin(), file.string());
    return scene;
  }
  scene.materials = read_materials(member(value, "materials"), where / "materials");
  const Json& models = member(value, "models");
  for (std::size_t i = 0; i < models.size(); ++i) {
    scene.models.push_back(read_model(models[i], where / "models" / i, scene.materials));
    scene.input_files.push_back(scene.models.back().file.string());
  }
  const Json& meshes = member(value, "meshes");
  for (std::size_t i = 0; i < meshes.size(); ++i)
    scene.meshes.push_back(read_mesh(meshes[i], where / "meshes" / i, scene.materials));
  const Json& spheres = member(value, "spheres");
  for (std::size_t i = 0; i < spheres.size(); ++i)
    scene.spheres.push_back(
        {read_vector3(spheres[i]["center_m"]), spheres[i]["radius_m"].get<double>(),
         read_material_name(spheres[i]["material"], where / "spheres" / i / "material", scene.materials)});
  for (const Json& light : member(value, "lights"))
    scene.lights.push_back({read_vector3(light["position_m"]), read_vector3(light["intensity"])});
  if (const Json& environment = member(value, "environment"); environment.is_object()) {
    scene.environment = read_environment(environment, where / "environment");
    if (scene.environment->file) scene.input_files.push_back(scene.environment->file->string());
  }
  return scene;
}

}  // namespace sturm
