#pragma once
#include <Eigen/Core>

namespace sturm {

/// Height z of a surface over the plane through its vertex, with its derivatives. Surface frame: origin at the vertex,
/// axes parallel to those of the wearer frame, so z > 0 lies towards the eye and a radius R > 0 (centre on the eye's
/// side) gives z ≈ +r²/(2R).
struct Sag {
  double value;              ///< [m]
  Eigen::Vector2d gradient;  ///< (∂z/∂x, ∂z/∂y)
  Eigen::Matrix2d hessian;   ///< [1/m]
};

/// Height and gradient alone, which is what a search for a ray's crossing needs at each of its steps: the same bits as
/// Sag's.
struct SagSlope {
  double value;              ///< [m]
  Eigen::Vector2d gradient;  ///< (∂z/∂x, ∂z/∂y)
};

/// Unit normal that points outward, away from the eye: (∂z/∂x, ∂z/∂y, −1)/√(1 + |∇z|²).
Eigen::Vector3d outward_normal(const Sag& sag);

/// A surface to second order about one of its points, in any frame.
struct SurfaceElement {
  Eigen::Vector3d normal;  ///< unit, outward
  Eigen::Matrix3d
      curvature;  ///< [1/m]; on tangent vectors t, w: tᵀ · curvature · w, positive where the centre lies outward

  SurfaceElement() = default;

  /// In the surface's own frame.
  SurfaceElement(const Sag& sag);

  /// In a frame in which the surface stands turned.
  SurfaceElement turned(const Eigen::Matrix3d& rotation) const;
};

/// Curvature matrix of the surface on two tangent vectors u, w [1/m], positive where the centre of curvature lies
/// outward of the surface: ahead of a wave that leaves the eye (docs/theory.md#112-a-wavefront-along-the-chief-ray).
/// K(t, t) = −tᵀ∇∇z t/√(1 + |∇z|²).
Eigen::Matrix2d tangent_curvature(const SurfaceElement& element, const Eigen::Vector3d& u, const Eigen::Vector3d& w);

}  // namespace sturm
