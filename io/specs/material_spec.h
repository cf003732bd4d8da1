#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>

#include "io/json/json.h"

namespace sturm {

// Kinds of surfaces as a scene states them; what they do is said in pathtrace/materials/.
struct DiffuseSpec {};
struct ConductorSpec {
  std::optional<std::string> metal;      ///< gold, copper, silver or aluminium; else eta and k
  Eigen::Vector3d eta{0.0, 0.0, 0.0};    ///< real part of the index
  Eigen::Vector3d kappa{0.0, 0.0, 0.0};  ///< extinction
  double roughness = 0.0;
};
struct DielectricSpec {
  double index = 1.5, roughness = 0.0;
};
struct PlasticSpec {
  double index = 1.5, roughness = 0.0;
};
struct SeedDiffuseSpec {};
struct SeedMetalSpec {
  double alpha = 0.0;
};
struct SeedDielectricSpec {
  double index = 1.5;
};
using SurfaceSpec = std::variant<DiffuseSpec, ConductorSpec, DielectricSpec, PlasticSpec, SeedDiffuseSpec,
                                 SeedMetalSpec, SeedDielectricSpec>;

/// A material; linear Rec. 709.
struct MaterialSpec {
  std::string name;
  Eigen::Vector3d albedo{0.0, 0.0, 0.0};
  Eigen::Vector3d emission{0.0, 0.0, 0.0};  ///< radiance
  SurfaceSpec surface{};
};

/// Reads a material that the schema has accepted. Throws InputError for a key that its type does not have, a conductor
/// without or with two statements of its index, and a roughness between 0 and 0.01.
MaterialSpec read_material(const std::string& name, const Json& value, const Source& where);

}  // namespace sturm
