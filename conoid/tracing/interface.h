#pragma once
#include <Eigen/Core>
#include <optional>

namespace sturm {

/// A surface as the neighbourhood of a chief ray meets it: Snell's law and the frames of generalised Coddington
/// (docs/theory.md#112-a-wavefront-along-the-chief-ray). (u, v) is the frame across the incoming ray, (u, v_out) across
/// the outgoing one, (u, n × u) in the surface's tangent plane.
struct Interface {
  Eigen::Vector3d u, v, v_out;         ///< u ⊥ plane of incidence; v = N × u, v_out = N' × u
  Eigen::Vector3d tangent;             ///< n × u
  Eigen::Vector3d direction_out;       ///< N'
  double mu = 1.0;                     ///< n₁/n₂
  double cos_in = 1.0, cos_out = 1.0;  ///< N · n > 0 and N' · n; the latter < 0 for a reflection
  double gamma = 0.0;                  ///< cos φ' − μ cos φ

  /// Refraction from index n₁ into n₂ at a surface with unit normal `normal`, normal · direction > 0. None at total
  /// internal reflection.
  static std::optional<Interface> refracting(const Eigen::Vector3d& direction, const Eigen::Vector3d& normal,
                                             double index_before, double index_behind);

  /// Mirror: μ = 1, cos φ' = −cos φ.
  static Interface reflecting(const Eigen::Vector3d& direction, const Eigen::Vector3d& normal);
};

/// Takes components on (from₁, from₂) to components on (to₁, to₂), two bases of one plane, by their four dot products:
/// frames of opposite handedness are no special case.
Eigen::Matrix2d change_of_frame(const Eigen::Vector3d& from1, const Eigen::Vector3d& from2, const Eigen::Vector3d& to1,
                                const Eigen::Vector3d& to2);

}  // namespace sturm
