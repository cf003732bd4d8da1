#pragma once
#include <Eigen/Core>
#include <optional>

#include "conoid/tracing/five_variables.h"
#include "lensmodel/eye.h"
#include "lensmodel/spectacles.h"

namespace sturm {

/// Conoid tracing as printed in [Kakimoto2010]: the conoid's cross section is an ellipse whose axes lie along the
/// wavefront's principal directions everywhere (eqs. 9–11). Behind an oblique or toric surface that is an
/// approximation; the exact first order is `ray_transfer`.
struct PublishedConoid {
  FiveVariables wave;  ///< at the exit point
  /// Semi-axes along wave.e1 and wave.e2 in pupil radii, with sign: negative behind a focal line.
  double epsilon1, epsilon2;
};

/// The axes on the surface's tangent plane on which eq. 11 matches the ellipses. The paper does not name them.
enum class TangentAxes {
  incidence,  ///< u ⊥ plane of incidence, and n × u: singular where the refracted principal directions stand at 45° to
              ///< it
  principal  ///< along the projection of the refracted wave's e'₁
};

/// Why eq. 11 has no ellipse behind a surface.
enum class Eq11Failure {
  no_length,  ///< an axis in front of the surface has no length: E is infinite
  singular,   ///< a refracted principal direction stands at 45° to the axes (to 1e-6 of the determinant)
  negative    ///< the solution has a square ε'² = 1/E' that is not positive
};

/// Semi-axes of a conoid's section along the two principal directions of its wave.
struct SemiAxes {
  double first, second;  ///< along e1 and e2, in pupil radii, with sign
};

/// Eq. 11: the semi-axes behind a surface from E = 1/ε² in front of it, matching xx and yy of the ellipses' quadratic
/// forms on the tangent plane; xy is dropped. None where that is singular or turns E' negative, and where an axis has
/// no length; `why` (if given) then says which.
std::optional<SemiAxes> refracted_semi_axes(const SemiAxes& axes, const FiveVariables& before,
                                            const FiveVariables& behind, const Eigen::Vector3d& normal,
                                            TangentAxes tangent, Eq11Failure* why = nullptr);

/// From the pupil of the eye turned to `gaze`, with the slopes S = F − A·I, to the exit point. None where the chief ray
/// is lost or eq. 11 fails. `spectacles` null: the naked eye, exact.
std::optional<PublishedConoid> trace_published(const Eye& eye, double accommodation_D, const Spectacles* spectacles,
                                               const Eigen::Vector3d& gaze,
                                               TangentAxes tangent = TangentAxes::principal);

/// A traced conoid, or what stopped it.
struct PublishedTrace {
  std::optional<PublishedConoid> conoid;  ///< none where the chief ray was lost or eq. 11 failed
  std::optional<Eq11Failure> failure;     ///< of eq. 11; none where the chief ray was lost
  /// Behind a surface the wave was a plane or a sphere, without principal directions, but the section was not a circle:
  /// it kept its own axes. A relaxed eye behind the lens that corrects it sends out such a wave on the axis.
  bool free_axes = false;
};

/// The same as trace_published, with what stopped it.
PublishedTrace trace_published_or_why(const Eye& eye, double accommodation_D, const Spectacles* spectacles,
                                      const Eigen::Vector3d& gaze, TangentAxes tangent = TangentAxes::principal);

/// The ellipse at 1/d as a symmetric map of the pupil's disc on (f1, f2), divided by d [rad/m]: Σ ε_i(d)/d e_i e_iᵀ.
Eigen::Matrix2d angular_map(const PublishedConoid& conoid, const Eigen::Vector3d& f1, const Eigen::Vector3d& f2,
                            double vergence_D);

/// The ellipse of an eye that accommodates as well as it can.
struct PublishedAccommodation {
  double t;             ///< share of the tense eye, 0 … 1
  Eigen::Matrix2d map;  ///< (1 − t) R + t T, divided by d [rad/m]
};

/// Eq. 12: mix of the relaxed (R) and the tense (T) eye's ellipse, t = clamp((ε_R1 + ε_R2)/(ε_R1 + ε_R2 − ε_T1 − ε_T2),
/// 0, 1). Sums of semi-axes are traces, so the maps are mixed as matrices: their principal directions need not agree.
PublishedAccommodation mixed(const Eigen::Matrix2d& relaxed, const Eigen::Matrix2d& tense);

}  // namespace sturm
