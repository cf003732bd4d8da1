#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "compare/ellipses/bundle_moments.h"

namespace sturm {

/// A difference between a measured and a predicted ellipse. Lengths in the unit u of the points.
struct EllipseMeasure {
  double value = 0.0;
  std::optional<double> standard_error;
  std::optional<double>
      z;  ///< deviation from what a bundle of exactly the predicted moments would give, in standard errors
};

/// All measures of how far apart two ellipses are. Those that mean nothing are none (area and overlap of a predicted
/// focal line, the orientation of a circle); standard errors and z are none where the bundle has no error of its own.
struct EllipseMeasures {
  // Signed, with closed-form standard errors from the covariance of the entries; z = value/error.
  EllipseMeasure semi_major;                  ///< measured − predicted [u]
  EllipseMeasure semi_minor;                  ///< measured − predicted [u]
  std::optional<EllipseMeasure> orientation;  ///< measured − predicted [deg], (−90, 90]; se = se(uᵀΣv)/(λ₁ − λ₂)
  std::optional<EllipseMeasure> log_area_ratio;  ///< ln(measured/predicted area); se² = ¼·Var(tr Σ⁻¹δΣ)

  // Never negative, so that noise alone makes them positive: standard errors and z by the parametric bootstrap, see
  // below.
  EllipseMeasure frobenius;          ///< ‖measured − predicted‖_F of the second moments [u²]
  EllipseMeasure bures_wasserstein;  ///< [u]
  std::optional<EllipseMeasure>
      missing_overlap;  ///< 1 − intersection over union of the supports 2·√Σ, centred `offset` apart
};

/// Compares a measured bundle with predicted second moments [u²] whose centre lies `offset` [u] from the bundle's.
///
/// Parametric bootstrap: `draws` second moments from the normal distribution with the bundle's entry covariance, once
/// about the measured moments (their scatter is the standard error) and once about the predicted ones (mean and scatter
/// of what noise alone gives: z = (value − mean)/scatter). Deterministic for a seed. Draws that are not positive
/// semidefinite are projected onto the nearest that is.
EllipseMeasures measure_ellipses(const BundleEllipse& measured, const Eigen::Matrix2d& predicted,
                                 const Eigen::Vector2d& offset = Eigen::Vector2d::Zero(), std::uint64_t seed = 1,
                                 int draws = 256);

}  // namespace sturm
