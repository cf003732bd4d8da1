#pragma once
#include "pathtrace/materials/bsdf.h"

namespace sturm {

/// Clear glass between the front (index 1) and the back (index `index`) of a surface; GGX microfacets, roughness 0 is a
/// smooth surface.
///
/// Reflection as of a Conductor; transmission by [Walter2007, eq. 21] with masking and shadowing independent of each
/// other. What is carried is radiance, which a refraction scales by (near index / far index)², so f is not symmetric
/// across the surface but n_out⁻² f(out, in) is [Veach1997, §5.2]. A smooth surface conserves energy exactly; a rough
/// one loses what would scatter more than once. A body needs a closed surface whose normals point outwards. Nothing is
/// absorbed inside.
struct Dielectric {
  float index = 1.5f;
  float roughness = 0.0f;  ///< α = roughness²; 0, or from 0.01 to 1

  BsdfValue evaluate(const Eigen::Vector3f& out, const Eigen::Vector3f& in, const Eigen::Vector3f& albedo) const;
  BsdfSample sample(const Eigen::Vector3f& out, const BsdfNumbers& numbers, const Eigen::Vector3f& albedo) const;
};

}  // namespace sturm
