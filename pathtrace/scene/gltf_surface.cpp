#include "pathtrace/scene/gltf_surface.h"

#include "pathtrace/materials/tinted_metal.h"

namespace sturm {

namespace {

constexpr float least_roughness = 0.01f;  // below it a conductor or coat must be perfectly smooth

}  // namespace

GltfSurface gltf_surface(const GltfFactors& factors) {
  const float roughness = factors.roughness < least_roughness ? 0.0f : factors.roughness;
  const std::string mixture =
      factors.metallic > 0.0f && factors.metallic < 1.0f ? "mixture of metal and dielectric" : "";
  if (factors.metallic >= 0.5f) return {metal_that_reflects(factors.base_colour, roughness), mixture};
  if (roughness >= 1.0f) return {Diffuse{}, mixture};
  return {Plastic(factors.index, roughness), mixture};
}

}  // namespace sturm
