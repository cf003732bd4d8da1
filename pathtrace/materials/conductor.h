#pragma once
#include "pathtrace/materials/bsdf.h"

namespace sturm {

/// A metal: GGX microfacets with Fresnel's equations for a complex index; roughness 0 is a mirror.
///
/// f = F D G₂ / (4 cos θ_out cos θ_in), sampled by visible normals [Heitz2018]. Reciprocal. Light that would leave
/// after more than one reflection among the facets is lost: a white metal reflects 1 at roughness 0 and the less the
/// rougher it is (docs/theory.md#93-estimators).
struct Conductor {
  Eigen::Vector3f eta{0.0f, 0.0f, 0.0f};    ///< real part of the index, per channel
  Eigen::Vector3f kappa{1.0f, 1.0f, 1.0f};  ///< extinction, per channel; η = 0 reflects everything
  float roughness = 0.0f;                   ///< α = roughness²; 0, or from 0.01 to 1

  BsdfValue evaluate(const Eigen::Vector3f& out, const Eigen::Vector3f& in, const Eigen::Vector3f& albedo) const;
  BsdfSample sample(const Eigen::Vector3f& out, const BsdfNumbers& numbers, const Eigen::Vector3f& albedo) const;
};

}  // namespace sturm
