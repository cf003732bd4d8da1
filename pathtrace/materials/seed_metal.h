#pragma once
#include "pathtrace/materials/ball_lobe.h"
#include "pathtrace/materials/bsdf.h"

namespace sturm {

/// METALSTIGMATISM's metal: the next direction is the mirror direction m + alpha · a random point of the unit ball, the
/// path's weight is multiplied by albedo (0.2 + 0.8 spec), read here with spec = max(0, m·in). Directions below the
/// surface end the path. Not physical: not reciprocal, no Fresnel, and it loses energy at grazing angles and with
/// growing alpha for no reason but its form.
struct SeedMetal {
  float alpha = 0.0f;  ///< 0 … 1; 0 is a mirror of weight albedo

  BsdfValue evaluate(const Eigen::Vector3f& out, const Eigen::Vector3f& in, const Eigen::Vector3f& albedo) const {
    if (alpha == 0.0f || !(in.z() > 0.0f)) return BsdfValue::none();
    const Eigen::Vector3f mirror = local::mirrored(out);
    const float pdf = BallLobe{alpha}.pdf(mirror, in);
    return {(pdf * weight(mirror, in)) * albedo, pdf};
  }

  BsdfSample sample(const Eigen::Vector3f& out, const BsdfNumbers& numbers, const Eigen::Vector3f& albedo) const {
    const Eigen::Vector3f mirror = local::mirrored(out);
    if (alpha == 0.0f) return {mirror, albedo, 1.0f, true};
    const Eigen::Vector3f in = BallLobe{alpha}.sample(mirror, numbers);
    const float pdf = BallLobe{alpha}.pdf(mirror, in);
    if (!(in.z() > 0.0f) || !(pdf > 0.0f)) return BsdfSample::absorbed();
    return {in, weight(mirror, in) * albedo, pdf, false};
  }

 private:
  static float weight(const Eigen::Vector3f& mirror, const Eigen::Vector3f& in) {
    return 0.2f + 0.8f * std::max(0.0f, mirror.dot(in));
  }
};

}  // namespace sturm
