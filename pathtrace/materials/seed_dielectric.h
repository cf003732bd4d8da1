#pragma once
#include "pathtrace/materials/bsdf.h"
#include "pathtrace/materials/fresnel.h"

namespace sturm {

/// METALSTIGMATISM's glass: smooth; reflects with Schlick's probability for F₀ = 0.2 whatever the index and the side,
/// else refracts. The path's weight is multiplied by the albedo. Not physical: glass of index 1.5 has F₀ = 0.04,
/// Schlick's formula misses total internal reflection (which is taken from Snell's law here), and radiance is not
/// scaled by the square of the index.
struct SeedDielectric {
  static constexpr float reflectance_at_normal = 0.2f;
  float index = 1.5f;

  static BsdfValue evaluate(const Eigen::Vector3f&, const Eigen::Vector3f&, const Eigen::Vector3f&) {
    return BsdfValue::none();
  }

  BsdfSample sample(const Eigen::Vector3f& out, const BsdfNumbers& numbers, const Eigen::Vector3f& albedo) const {
    const float side = out.z() > 0.0f ? 1.0f : -1.0f, eta = out.z() > 0.0f ? index : 1.0f / index;
    const Eigen::Vector3f above = side * out;
    const float cosine_in = fresnel_dielectric(std::min(1.0f, above.z()), eta).cosine_in;
    const float reflectance = cosine_in > 0.0f ? fresnel_schlick(above.z(), reflectance_at_normal) : 1.0f;
    if (numbers.lobe < reflectance) return {local::mirrored(out), albedo, reflectance, true};
    return {side * local::refracted(above, {0.0f, 0.0f, 1.0f}, cosine_in, eta), albedo, 1.0f - reflectance, true};
  }
};

}  // namespace sturm
