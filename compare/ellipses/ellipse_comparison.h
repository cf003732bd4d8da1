#pragma once
#include <Eigen/Core>
#include <optional>

#include "compare/ellipses/bundle_moments.h"

namespace sturm {

/// A predicted axis shorter than this share of the longer one has no meaningful relative error (a focal line): it is
/// null, and the error is given as a length.
inline constexpr double near_zero_axis_ratio = 0.01;

/// A ratio of semi-axes above this makes an ellipse a circle as far as its orientation is concerned.
inline constexpr double circle_axis_ratio = 0.99;

/// How far a measured ellipse is from a predicted one. Lengths in the unit u of the points.
struct EllipseComparison {
  /// Signed deviations in standard errors **along the predicted axes** (variance along the major, along the minor axis,
  /// and their covariance): near a circle measured eigenvalues are biased apart and the measured angle means nothing
  /// (docs/theory.md#71-from-a-bundle-of-rays). None where the bundle has no standard error. With R replicates each is
  /// distributed as Student's t with R − 1 degrees of freedom.
  std::optional<Eigen::Vector3d> z;

  std::optional<double> z_max;  ///< largest |z|
  std::optional<double>
      relative_frobenius;  ///< ‖measured − predicted‖_F/‖predicted‖_F of the covariances; none for a predicted point
  double semi_major_error = 0.0;                    ///< measured − predicted [u]
  double semi_minor_error = 0.0;                    ///< measured − predicted [u]
  std::optional<double> semi_major_relative_error;  ///< none for a predicted point
  std::optional<double> semi_minor_relative_error;  ///< none for a predicted axis that is (nearly) zero
  std::optional<double>
      orientation_error_deg;       ///< measured − predicted, folded to (−90, 90]; none where either is a circle
  double bures_wasserstein = 0.0;  ///< distance of the two centred Gaussians [u]
};

/// Compares a measured bundle with a predicted covariance [u²]. The standard errors get a floor of rounding, 64 ε of
/// the predicted total variance, so that a bundle that is right to the last digits (a focal line of zero width) has a z
/// of order one and not 0/0.
EllipseComparison compare_to_prediction(const BundleEllipse& measured, const Eigen::Matrix2d& predicted);

/// Bures–Wasserstein distance of two positive semidefinite 2×2 matrices [u²]; the result is a length [u]:
/// √(tr A + tr B − 2·√(tr AB + 2√(det A det B))). Computed as min over rotations R of ‖√A − √B R‖_F, which is the same
/// number without the cancellation, so that nearly equal matrices keep a distance below √ε.
double bures_wasserstein_distance(const Eigen::Matrix2d& a, const Eigen::Matrix2d& b);

/// Covariance of the `sin2_radial` pattern of a uniform pupil of radius `a` [m] under the symmetric vergence matrix V
/// [D] (docs/theory.md#61-second-moments-in-closed-form): with V = m·I + D (D without trace, D² = δ²·I), a²/4·(m²·I +
/// m·D + δ²/2·I); its principal values are a²/4·(5V₁² + 2V₁V₂ + V₂²)/8 and a²/4·(V₁² + 2V₁V₂ + 5V₂²)/8. (Wavefront
/// theory: a²/4·V² = a²/4·(m²·I + 2m·D + δ²·I).)
Eigen::Matrix2d sin2_closed_form_covariance(const Eigen::Matrix2d& v, double a);

}  // namespace sturm
