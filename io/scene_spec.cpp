#include "io/scene_spec.h"

#include <nlohmann/json.hpp>

#include "io/error.h"
#include "io/json_vectors.h"
#include "io/named_file.h"
#include "io/suggest.h"

namespace sturm {

namespace {

const Json& member(const Json& object, const char* key) {
  static const Json nothing = Json::array();
  const auto at = object.find(key);
  return at == object.end() ? nothing : *at;
}

ModelSpec read_model(const Json& value, const Source& where) {
  ModelSpec model;
  model.file = existing_file(value["file"], where / "file", "the path of a model file");
  model.scale = value.value("scale", model.scale);
  if (value.value("texture_encoding", "srgb") == "linear") model.texture_encoding = TextureEncoding::Linear;
  if (value.value("texture_filter", "bilinear") == "nearest") model.texture_filter = TextureFilter::Nearest;
  return model;
}

std::vector<MaterialSpec> read_materials(const Json& object) {
  std::vector<MaterialSpec> materials;
  for (const auto& [name, value] : object.items()) {
    MaterialSpec material;
    material.name = name;
    if (value.contains("albedo")) material.albedo = read_vector3(value["albedo"]);
    if (value.contains("emission")) material.emission = read_vector3(value["emission"]);
    materials.push_back(material);
  }
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
        (where / "faces" / f / c).fail(faces[f][c], "the number of a vertex, from 0 to " + std::to_string(mesh.positions.size() - 1));
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
    const std::filesystem::path file = existing_file(value, where, "the path of a scene or model file");
    if (file.extension() != ".json") {
      scene.models.push_back({.file = file});
      scene.input_files.push_back(file.string());
      return scene;
    }
    scene = read_scene(load_named_document(value, where, "scene"), {file.string(), ""});
    scene.input_files.insert(scene.input_files.begin(), file.string());
    return scene;
  }
  const Json& models = member(value, "models");
  for (std::size_t i = 0; i < models.size(); ++i) {
    scene.models.push_back(read_model(models[i], where / "models" / i));
    scene.input_files.push_back(scene.models.back().file.string());
  }
  scene.materials = read_materials(member(value, "materials"));
  const Json& meshes = member(value, "meshes");
  for (std::size_t i = 0; i < meshes.size(); ++i) scene.meshes.push_back(read_mesh(meshes[i], where / "meshes" / i, scene.materials));
  const Json& spheres = member(value, "spheres");
  for (std::size_t i = 0; i < spheres.size(); ++i)
    scene.spheres.push_back({read_vector3(spheres[i]["center_m"]), spheres[i]["radius_m"].get<double>(),
                             read_material_name(spheres[i]["material"], where / "spheres" / i / "material", scene.materials)});
  for (const Json& light : member(value, "lights"))
    scene.lights.push_back({read_vector3(light["position_m"]), read_vector3(light["intensity"])});
  return scene;
}

}  // namespace sturm
