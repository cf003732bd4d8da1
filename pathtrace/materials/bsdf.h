#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <numbers>

// What all materials share. Directions are unit vectors in the local frame of a surface point: z along the shading
// normal on the surface's front, `out` towards the viewer, `in` towards the light. Colours are linear Rec. 709.
namespace sturm {

/// Value and density of a material for a pair of directions. Perfectly sharp lobes count neither in one nor in the
/// other.
struct BsdfValue {
  Eigen::Vector3f value;  ///< f(out, in) · |cos θ_in| [1/sr]
  float pdf;              ///< of sampling `in` for `out` [1/sr]

  static BsdfValue none() { return {Eigen::Vector3f::Zero(), 0.0f}; }
};

/// A sampled direction.
struct BsdfSample {
  Eigen::Vector3f in;
  Eigen::Vector3f weight;  ///< f · |cos θ_in| / pdf
  float pdf;               ///< [1/sr]; of a sharp lobe the probability of its choice; 0 = the path ends here
  bool delta;              ///< sharp: no light can be sampled in this direction
  float index_ratio_squared =
      1.0f;  ///< (index on the side of `in` / index on the side of `out`)²: `weight` is divided by it

  static BsdfSample absorbed() { return {Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero(), 0.0f, false, 1.0f}; }
};

/// Uniform numbers in [0, 1): two for a direction, one for the choice of a lobe (or for the depth in a ball).
struct BsdfNumbers {
  float u, v, lobe;
};

namespace local {
inline constexpr float pi = std::numbers::pi_v<float>;

inline Eigen::Vector3f mirrored(const Eigen::Vector3f& out) {
  return {-out.x(), -out.y(), out.z()};
}
/// `out` mirrored at the unit vector h.
inline Eigen::Vector3f reflected(const Eigen::Vector3f& out, const Eigen::Vector3f& h) {
  return 2.0f * out.dot(h) * h - out;
}
/// The direction into which `out` is refracted at the unit normal h with out·h > 0; `cosine_in` > 0 from
/// fresnel_dielectric, `eta` = index on the far side / index on the side of `out`.
inline Eigen::Vector3f refracted(const Eigen::Vector3f& out, const Eigen::Vector3f& h, float cosine_in, float eta) {
  return (out.dot(h) / eta - cosine_in) * h - out / eta;
}
}  // namespace local

}  // namespace sturm
