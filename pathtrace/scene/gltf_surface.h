#pragma once
#include <Eigen/Core>
#include <string>

#include "pathtrace/materials/surface_model.h"

namespace sturm {

/// The factors of glTF's metallic-roughness model [glTF 2.0 specification, section 3.9.2 and appendix B].
struct GltfFactors {
  float metallic = 1.0f, roughness = 1.0f;        ///< 0 … 1
  float index = 1.5f;                             ///< of the coat (KHR_materials_ior), > 1
  Eigen::Vector3f base_colour{1.0f, 1.0f, 1.0f};  ///< 0 … 1, linear Rec. 709; its texture's mean times its factor
};

struct GltfSurface {
  SurfaceModel surface;
  std::string left_out;  ///< what of the factors the surface does not have; "" if nothing
};

/// The surface nearest to glTF's model. GGX α is roughness² in both, so roughness is taken as it is (below 0.01:
/// perfectly smooth).
///
/// - metallic ≥ 0.5: a conductor that reflects the base colour at normal incidence: η = 1, κ = 2√(R/(1 − R)), R at most
/// 0.999. glTF has
///   Schlick's curve towards grazing incidence, this one Fresnel's.
/// - metallic < 0.5 and roughness 1: Lambert.
/// - otherwise: plastic, the base colour under a clear coat of that roughness. glTF sets the base beside the coat; here
/// light passes the
///   coat twice and is reflected between base and coat, which makes mid tones a little darker and more saturated.
///
/// Half metal is the nearer of the two (left out: the mixture).
GltfSurface gltf_surface(const GltfFactors& factors);

}  // namespace sturm
