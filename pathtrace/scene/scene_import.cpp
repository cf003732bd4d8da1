#include "pathtrace/scene/scene_import.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "io/files/error.h"
#include "io/files/readable_text.h"
#include "io/json/suggest.h"
#include "pathtrace/materials/fresnel.h"
#include "pathtrace/materials/named_metals.h"
#include "pathtrace/scene/assimp_import.h"
#include "pathtrace/scene/environment_picture.h"
#include "pathtrace/scene/lost_precision.h"

namespace sturm {
namespace {

template <class T>
void append(std::vector<T>& to, std::vector<T>&& from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

Conductor conductor(const ConductorSpec& spec) {
  Conductor c;
  c.roughness = static_cast<float>(spec.roughness);
  if (!spec.metal) {
    c.eta = spec.eta.cast<float>();
    c.kappa = spec.kappa.cast<float>();
    return c;
  }
  const auto metal = std::find_if(named_metals.begin(), named_metals.end(),
                                  [&](const NamedMetal& m) { return m.name == *spec.metal; });
  if (metal == named_metals.end()) throw InputError("", "metal", *spec.metal, "gold, copper, silver or aluminium");
  c.eta = Eigen::Vector3f(metal->eta.data());
  c.kappa = Eigen::Vector3f(metal->kappa.data());
  return c;
}

struct SurfaceBuilder {
  SurfaceModel operator()(const DiffuseSpec&) const { return Diffuse{}; }
  SurfaceModel operator()(const ConductorSpec& s) const { return conductor(s); }
  SurfaceModel operator()(const DielectricSpec& s) const {
    return Dielectric{static_cast<float>(s.index), static_cast<float>(s.roughness)};
  }
  SurfaceModel operator()(const PlasticSpec& s) const {
    return Plastic(static_cast<float>(s.index), static_cast<float>(s.roughness));
  }
  SurfaceModel operator()(const SeedDiffuseSpec&) const { return SeedDiffuse{}; }
  SurfaceModel operator()(const SeedMetalSpec& s) const { return SeedMetal{static_cast<float>(s.alpha)}; }
  SurfaceModel operator()(const SeedDielectricSpec& s) const { return SeedDielectric{static_cast<float>(s.index)}; }
};

Material build_material(const MaterialSpec& spec) {
  Material material;
  material.name = spec.name;
  material.albedo = spec.albedo.cast<float>();
  material.emission = spec.emission.cast<float>();
  material.surface = std::visit(SurfaceBuilder{}, spec.surface);
  // The albedo layer shows a metal by its colour seen straight on.
  if (const auto* metal = std::get_if<Conductor>(&material.surface))
    material.albedo = fresnel_conductor(1.0f, metal->eta, metal->kappa);
  return material;
}

bool is_named(const Mesh& mesh, const std::string& name) {
  return mesh.name == name || std::find(mesh.also_named.begin(), mesh.also_named.end(), name) != mesh.also_named.end();
}

/// Names by which overrides can find meshes, each once.
std::vector<std::string> names_of(const SceneDescription& model) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const std::vector<Mesh>* meshes : {&model.meshes, &model.prototypes})
    for (const Mesh& mesh : *meshes) {
      add(mesh.name);
      std::for_each(mesh.also_named.begin(), mesh.also_named.end(), add);
    }
  return names;
}

/// Every mesh of an override's name gets its material.
void apply_overrides(SceneDescription& model, const ModelSpec& spec) {
  for (const MaterialOverride& change : spec.overrides) {
    bool found = false;
    for (std::vector<Mesh>* meshes : {&model.meshes, &model.prototypes})
      for (Mesh& mesh : *meshes) {
        if (!is_named(mesh, change.mesh)) continue;
        found = true;
        mesh.material = static_cast<int>(model.materials.size());
        mesh.vertex_colours.clear();  // they belong to what the file says
      }
    if (!found) {
      const std::vector<std::string> names = names_of(model);
      throw InputError(spec.file.string(), "overrides", "\"" + change.mesh + "\"" + did_you_mean(change.mesh, names),
                       one_of(names) + " (meshes of this model)");
    }
    model.materials.push_back(build_material(change.material));
  }
}

/// A texture needs to know where on its mesh it lies.
void require_coordinates(const SceneDescription& model, const ModelSpec& spec) {
  for (const std::vector<Mesh>* meshes : {&model.meshes, &model.prototypes})
    for (const Mesh& mesh : *meshes) {
      const Material& material = model.materials[static_cast<std::size_t>(mesh.material)];
      if ((material.albedo_texture || material.emission_texture || material.opacity.texture) &&
          mesh.texture_coordinates.empty())
        throw InputError(spec.file.string(), "mesh \"" + mesh.name + "\"",
                         "faces without texture coordinates under the textured material \"" + material.name + "\"",
                         "texture coordinates at all of their corners");
    }
}

/// Lights must know where they are: instances of emitters become meshes in place.
void place_emitters(SceneDescription& model) {
  std::erase_if(model.instances, [&](const Instance& instance) {
    const Mesh& prototype = model.prototypes[static_cast<std::size_t>(instance.prototype)];
    if (!(model.materials[static_cast<std::size_t>(prototype.material)].emission.maxCoeff() > 0.0f)) return false;
    Mesh mesh = prototype;
    const Eigen::Matrix3f turn = instance.world_from_prototype.leftCols<3>();
    for (Eigen::Vector3f& p : mesh.positions) p = turn * p + instance.world_from_prototype.col(3);
    for (Eigen::Vector3f& n : mesh.normals) n = (turn.inverse().transpose() * n).normalized();
    if (turn.determinant() < 0.0f)
      for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    model.meshes.push_back(std::move(mesh));
    return true;
  });
  std::vector<int> kept(model.prototypes.size(), -1);
  std::vector<Mesh> prototypes;
  for (Instance& instance : model.instances) {
    int& number = kept[static_cast<std::size_t>(instance.prototype)];
    if (number < 0) {
      number = static_cast<int>(prototypes.size());
      prototypes.push_back(std::move(model.prototypes[static_cast<std::size_t>(instance.prototype)]));
    }
    instance.prototype = number;
  }
  model.prototypes = std::move(prototypes);
}

void append_model(SceneDescription& scene, SceneDescription&& model) {
  const int first_material = static_cast<int>(scene.materials.size());
  for (Mesh& mesh : model.meshes) mesh.material += first_material;
  for (Mesh& mesh : model.prototypes) mesh.material += first_material;
  for (Instance& instance : model.instances) instance.prototype += static_cast<int>(scene.prototypes.size());
  append(scene.materials, std::move(model.materials));
  append(scene.meshes, std::move(model.meshes));
  append(scene.prototypes, std::move(model.prototypes));
  append(scene.instances, std::move(model.instances));
  for (const std::string& note : model.notes) scene.notes.push_back(readable(note));  // names in files need not be text
}

}  // namespace

SceneDescription build_scene(const SceneSpec& spec) {
  SceneDescription scene;
  for (const MaterialSpec& m : spec.materials) scene.materials.push_back(build_material(m));
  for (const MeshSpec& m : spec.meshes) {
    Mesh mesh;
    mesh.name = m.name;
    mesh.material = m.material;
    mesh.triangles = m.triangles;
    for (const Eigen::Vector3d& p : m.positions) mesh.positions.push_back(p.cast<float>());
    if (const std::string lost = lost_precision(mesh, largest_coordinate_of(mesh)); !lost.empty())
      scene.notes.push_back(lost);
    scene.meshes.push_back(std::move(mesh));
  }
  for (const SphereSpec& s : spec.spheres)
    scene.spheres.push_back({s.center.cast<float>(), static_cast<float>(s.radius), s.material});
  for (const PointLightSpec& l : spec.lights)
    scene.lights.push_back({l.position.cast<float>(), l.intensity.cast<float>()});
  for (const ModelSpec& spec_of_model : spec.models) {
    SceneDescription model = import_model(spec_of_model);
    apply_overrides(model, spec_of_model);
    require_coordinates(model, spec_of_model);
    place_emitters(model);
    append_model(scene, std::move(model));
  }
  if (spec.environment)
    scene.environment =
        Environment{spec.environment->radiance.cast<float>(),
                    spec.environment->file ? read_environment_picture(*spec.environment, scene.notes) : nullptr,
                    static_cast<float>(spec.environment->rotation)};
  return scene;
}

}  // namespace sturm
