#pragma once
#include <Eigen/Core>

#include "conoid/tracing/interface.h"
#include "lensmodel/sag.h"

namespace sturm {

/// First-order neighbourhood of a chief ray (docs/theory.md#113-conoid-tracing-as-ray-transfer, `ray_transfer`): a ray
/// that starts with the offset p and the slope s across the chief ray has here, on the frame (e1, e2),
///
///     offset = offset_from_offset · p + offset_from_slope · s,   slope = slope_from_offset · p + slope_from_slope · s.
///
/// Nothing in it is singular at a focus. From air to air the 4×4 matrix is symplectic.
struct RayTransfer {
  Eigen::Vector3d direction;
  Eigen::Vector3d e1, e2;
  Eigen::Matrix2d offset_from_offset = Eigen::Matrix2d::Identity(), offset_from_slope = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d slope_from_offset = Eigen::Matrix2d::Zero(), slope_from_slope = Eigen::Matrix2d::Identity();

  /// At the start: the identity on the frame (e1, e2) across `direction`.
  static RayTransfer start(const Eigen::Vector3d& direction, const Eigen::Vector3d& e1, const Eigen::Vector3d& e2) {
    return {direction, e1, e2};
  }

  /// A and B of a bundle that starts with the slopes s = S p: here its rays have the offsets A p and the slopes B p.
  Eigen::Matrix2d offsets(const Eigen::Matrix2d& s) const { return offset_from_offset + offset_from_slope * s; }
  Eigen::Matrix2d slopes(const Eigen::Matrix2d& s) const { return slope_from_offset + slope_from_slope * s; }
};

/// Further along by d: A' = A + dB.
RayTransfer transferred(const RayTransfer& rays, double distance);

/// The same rays on another frame across their direction.
RayTransfer on_frame(const RayTransfer& rays, const Eigen::Vector3d& f1, const Eigen::Vector3d& f2);

/// Behind a surface: A' = C'C⁻¹A, B' = C'⁻¹(μ C B − γ K_s C⁻¹A). The result stands on (u, v_out).
RayTransfer through(const RayTransfer& rays, const Interface& at, const SurfaceElement& surface);

}  // namespace sturm
