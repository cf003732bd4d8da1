#include "pathtrace/scene/gltf_surface.h"

#include <algorithm>
#include <cmath>

namespace sturm {

namespace {

constexpr float least_roughness = 0.01f;    // below it a conductor or coat must be perfectly smooth
constexpr float most_reflectance = 0.999f;  // κ → ∞ as R → 1

Conductor metal_of(const Eigen::Vector3f& reflectance, float roughness) {
  Conductor metal;
  metal.roughness = roughness;
  for (int k = 0; k < 3; ++k) {
    const float r = std::min(reflectance[k], most_reflectance);
    metal.eta[k] = 1.0f;
    metal.kappa[k] = 2.0f * std::sqrt(r / (1.0f - r));  // R = κ²/(4 + κ²) at η = 1
  }
  return metal;
}

}  // namespace

GltfSurface gltf_surface(const GltfFactors& factors) {
  const float roughness = factors.roughness < least_roughness ? 0.0f : factors.roughness;
  const std::string mixture =
      factors.metallic > 0.0f && factors.metallic < 1.0f ? "mixture of metal and dielectric" : "";
  if (factors.metallic >= 0.5f) return {metal_of(factors.base_colour, roughness), mixture};
  if (roughness >= 1.0f) return {Diffuse{}, mixture};
  return {Plastic(factors.index, roughness), mixture};
}

}  // namespace sturm
