#pragma once
#include "pathtrace/materials/bsdf.h"
#include "pathtrace/sampling/disk.h"

namespace sturm {

/// Lambert: f = albedo/π, sampled by the cosine. Conserves energy (reflects exactly the albedo), reciprocal.
struct Diffuse {
  static BsdfValue evaluate(const Eigen::Vector3f&, const Eigen::Vector3f& in, const Eigen::Vector3f& albedo) {
    if (!(in.z() > 0.0f)) return BsdfValue::none();
    const float pdf = in.z() / local::pi;
    return {pdf * albedo, pdf};
  }

  static BsdfSample sample(const Eigen::Vector3f&, const BsdfNumbers& numbers, const Eigen::Vector3f& albedo) {
    const auto d = concentric_disk(numbers.u, numbers.v);
    const float z = std::sqrt(std::max(0.0f, 1.0f - d.x * d.x - d.y * d.y));
    return {{d.x, d.y, z}, albedo, z / local::pi, false};
  }
};

}  // namespace sturm
