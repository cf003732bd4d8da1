#pragma once
#include "pathtrace/materials/conductor.h"

namespace sturm {

/// A metal that reflects these shares at normal incidence: η = 1 and κ = 2√(R/(1 − R)), from R = κ²/(4 + κ²); R at most
/// 0.999.
Conductor metal_that_reflects(const Eigen::Vector3f& reflectance, float roughness);

/// Such a metal whose reflectance at normal incidence is the albedo of each point: a metal with a texture or with
/// vertex colours.
struct TintedMetal {
  float roughness = 0.0f;  ///< as a Conductor's

  BsdfValue evaluate(const Eigen::Vector3f& out, const Eigen::Vector3f& in, const Eigen::Vector3f& albedo) const {
    return metal_that_reflects(albedo, roughness).evaluate(out, in, albedo);
  }
  BsdfSample sample(const Eigen::Vector3f& out, const BsdfNumbers& numbers, const Eigen::Vector3f& albedo) const {
    return metal_that_reflects(albedo, roughness).sample(out, numbers, albedo);
  }
};

}  // namespace sturm
