#pragma once
#include <Eigen/Geometry>
#include <cmath>

#include "pathtrace/materials/bsdf.h"
#include "pathtrace/sampling/vector_math.h"

namespace sturm {

/// Directions of axis + spread·b, with b uniform in the unit ball and 0 < spread ≤ 1: how many small path tracers
/// perturb a direction.
struct BallLobe {
  float spread;

  Eigen::Vector3f sample(const Eigen::Vector3f& axis, const BsdfNumbers& numbers) const {
    const float z = 1.0f - 2.0f * numbers.u, angle = 2.0f * local::pi * numbers.v,
                radius = spread * std::cbrt(numbers.lobe);
    const float ring = radius * std::sqrt(std::max(0.0f, 1.0f - z * z));
    return (axis + Eigen::Vector3f(ring * std::cos(angle), ring * std::sin(angle), radius * z)).normalized();
  }

  /// Density [1/sr]: the ray from the origin along w lies inside the ball from t₁ to t₂, so ∫ t² dt / (4π/3 spread³).
  float pdf(const Eigen::Vector3f& axis, const Eigen::Vector3f& w) const {
    const float middle = axis.dot(w), square = spread * spread - axis.cross(w).squaredNorm();
    if (!(middle > 0.0f) || !(square > 0.0f)) return 0.0f;
    const float half = std::sqrt(square);
    // (t₂³ − t₁³)/3 with t = middle ± half
    return (2.0f * half * middle * middle + (2.0f / 3.0f) * half * half * half) * 3.0f /
           (4.0f * local::pi * spread * spread * spread);
  }
};

}  // namespace sturm
