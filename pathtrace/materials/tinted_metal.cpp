#include "pathtrace/materials/tinted_metal.h"

#include <algorithm>
#include <cmath>

namespace sturm {

namespace {
constexpr float most_reflectance = 0.999f;  // κ → ∞ as R → 1
}  // namespace

Conductor metal_that_reflects(const Eigen::Vector3f& reflectance, float roughness) {
  Conductor metal;
  metal.roughness = roughness;
  for (int k = 0; k < 3; ++k) {
    const float r = std::min(reflectance[k], most_reflectance);
    metal.eta[k] = 1.0f;
    metal.kappa[k] = 2.0f * std::sqrt(r / (1.0f - r));
  }
  return metal;
}

}  // namespace sturm
