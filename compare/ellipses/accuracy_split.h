#pragma once
#include <Eigen/Core>
#include <optional>

namespace sturm {

/// How far a covariance is from another. Lengths in the unit u of the points.
struct CovarianceError {
  std::optional<double> relative_frobenius;  ///< ‖is − should‖_F/‖should‖_F; none where `should` has no width
  Eigen::Vector2d semi_axes;                 ///< is − should, semi-axes 2·√eigenvalue sorted by size [u]
  double half_width = 0.0;  ///< largest |is − should| of the half-width 2·√(uᵀ C u) over all directions u [u]
};

/// The half-width is compared in directions 1° apart and along the axes of both ellipses: unlike sorted semi-axes it
/// sees a turned ellipse.
CovarianceError covariance_error(const Eigen::Matrix2d& is, const Eigen::Matrix2d& should);

/// p of an error that grows as size^p, from its values at two sizes. None where either value is not above `rounding`,
/// or of another sign.
std::optional<double> convergence_order(double error_small, double error_large, double size_small, double size_large,
                                        double rounding = 0.0);

/// Real-ray covariances at two pupil radii against the first order that they should have.
struct OrderFit {
  std::optional<double> absolute;  ///< order of ‖C − a²/4 X Xᵀ‖_F in the pupil: 4 where the first order is right and an
                                   ///< aberration is left
  std::optional<double> relative;  ///< order of the same over ‖C‖_F: 2, unless the first order has (nearly) no width
  /// ‖C₀ − ¼ X Xᵀ‖_F/‖¼ X Xᵀ‖_F with C₀ = lim C/a² for a → 0, extrapolated from C/a² = C₀ + a² C₂ + O(a⁴) (Richardson).
  std::optional<double> limit_relative;
};

/// `x`: footprint X/d [rad/m]; `small`, `large`: covariances [rad²] of the real rays through pupils of these radii [m].
OrderFit fit_orders(const Eigen::Matrix2d& x, const Eigen::Matrix2d& small, double small_radius_m,
                    const Eigen::Matrix2d& large, double large_radius_m);

}  // namespace sturm
