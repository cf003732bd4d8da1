#pragma once
#include "pathtrace/materials/ball_lobe.h"
#include "pathtrace/materials/bsdf.h"

namespace sturm {

/// METALSTIGMATISM's diffuse surface, as read here: the next direction is normal + a random point of the unit ball, the
/// path's weight is multiplied by the albedo. Its lobe, 2 cos³θ/π, is narrower than Lambert's. It reflects the albedo,
/// but is not reciprocal.
struct SeedDiffuse {
  static BsdfValue evaluate(const Eigen::Vector3f&, const Eigen::Vector3f& in, const Eigen::Vector3f& albedo) {
    if (!(in.z() > 0.0f)) return BsdfValue::none();
    const float pdf = 2.0f * in.z() * in.z() * in.z() / local::pi;
    return {pdf * albedo, pdf};
  }

  static BsdfSample sample(const Eigen::Vector3f&, const BsdfNumbers& numbers, const Eigen::Vector3f& albedo) {
    const Eigen::Vector3f in = BallLobe{1.0f}.sample({0.0f, 0.0f, 1.0f}, numbers);
    if (!(in.z() > 0.0f)) return BsdfSample::absorbed();
    return {in, albedo, 2.0f * in.z() * in.z() * in.z() / local::pi, false};
  }
};

}  // namespace sturm
