#include "io/specs/material_spec.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/files/error.h"
#include "io/json/suggest.h"
#include "io/json/values.h"

namespace sturm {

namespace {

struct Kind {
  const char* type;
  std::vector<std::string> keys;  // beside type and emission
  bool albedo_is_white;           // unless stated; else black
};

const std::array<Kind, 7>& kinds() {
  static const std::array<Kind, 7> all{{{"diffuse", {"albedo"}, false},
                                        {"conductor", {"metal", "eta", "k", "roughness"}, true},
                                        {"dielectric", {"index", "roughness"}, true},
                                        {"plastic", {"albedo", "index", "roughness"}, false},
                                        {"seed_diffuse", {"albedo"}, false},
                                        {"seed_metal", {"albedo", "alpha"}, false},
                                        {"seed_dielectric", {"albedo", "index"}, true}}};
  return all;
}

double read_roughness(const Json& value, const Source& where) {
  const double roughness = value.value("roughness", 0.0);
  if (roughness > 0.0 && roughness < 0.01)
    (where / "roughness")
        .fail(value["roughness"], "0 (perfectly smooth), or from 0.01 to 1");  // below, single precision cannot tell
  return roughness;
}

ConductorSpec read_conductor(const Json& value, const Source& where) {
  ConductorSpec conductor;
  conductor.roughness = read_roughness(value, where);
  const bool named = value.contains("metal"), measured = value.contains("eta") || value.contains("k");
  if (named == measured || value.contains("eta") != value.contains("k"))
    where.fail(value, "either \"metal\", or both \"eta\" and \"k\"");
  if (named) {
    conductor.metal = value["metal"].get<std::string>();
  } else {
    conductor.eta = read_vector3(value["eta"]);
    conductor.kappa = read_vector3(value["k"]);
  }
  return conductor;
}

SurfaceSpec read_surface(const std::string& type, const Json& value, const Source& where) {
  if (type == "conductor") return read_conductor(value, where);
  if (type == "dielectric") return DielectricSpec{value.value("index", 1.5), read_roughness(value, where)};
  if (type == "plastic") return PlasticSpec{value.value("index", 1.5), read_roughness(value, where)};
  if (type == "seed_diffuse") return SeedDiffuseSpec{};
  if (type == "seed_metal") return SeedMetalSpec{value.value("alpha", 0.0)};
  if (type == "seed_dielectric") return SeedDielectricSpec{value.value("index", 1.5)};
  return DiffuseSpec{};
}

}  // namespace

MaterialSpec read_material(const std::string& name, const Json& value, const Source& where) {
  const std::string type = value.value("type", "diffuse");
  const Kind& kind = *std::find_if(kinds().begin(), kinds().end(), [&](const Kind& k) { return k.type == type; });
  for (const auto& [key, member] : value.items())
    if (key != "type" && key != "emission" && std::find(kind.keys.begin(), kind.keys.end(), key) == kind.keys.end())
      throw InputError(
          where.file, (where / key).pointer, compact(member),
          "no such key: a material of type \"" + type + "\" has " + one_of(kind.keys) + ", and \"emission\"");
  MaterialSpec material;
  material.name = name;
  if (kind.albedo_is_white) material.albedo.setOnes();
  if (value.contains("albedo")) material.albedo = read_vector3(value["albedo"]);
  if (value.contains("emission")) material.emission = read_vector3(value["emission"]);
  material.surface = read_surface(type, value, where);
  return material;
}

}  // namespace sturm
