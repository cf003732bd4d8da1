#pragma once
#include <variant>

#include "pathtrace/materials/conductor.h"
#include "pathtrace/materials/dielectric.h"
#include "pathtrace/materials/diffuse.h"
#include "pathtrace/materials/plastic.h"
#include "pathtrace/materials/seed_dielectric.h"
#include "pathtrace/materials/seed_diffuse.h"
#include "pathtrace/materials/seed_metal.h"
#include "pathtrace/materials/tinted_metal.h"

namespace sturm {

/// How a surface scatters light. A new kind is a file of its own and a line here.
using SurfaceModel =
    std::variant<Diffuse, Conductor, Dielectric, Plastic, SeedDiffuse, SeedMetal, SeedDielectric, TintedMetal>;

/// True where light passes through, so that front and back differ; all other surfaces reflect on both sides alike.
template <class Model>
inline constexpr bool is_transparent = std::is_same_v<Model, Dielectric> || std::is_same_v<Model, SeedDielectric>;

/// f · |cos θ_in| and density; see BsdfValue.
BsdfValue evaluate(const SurfaceModel& model, const Eigen::Vector3f& out, const Eigen::Vector3f& in,
                   const Eigen::Vector3f& albedo);

/// A direction for `out`; see BsdfSample.
BsdfSample sample(const SurfaceModel& model, const Eigen::Vector3f& out, const BsdfNumbers& numbers,
                  const Eigen::Vector3f& albedo);

/// True where every direction that `sample` yields is sharp, so that lights need not be sampled.
bool only_sharp(const SurfaceModel& model);

}  // namespace sturm
