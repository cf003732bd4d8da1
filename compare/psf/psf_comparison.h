#pragma once
#include <array>
#include <optional>
#include <vector>

#include "compare/psf/distances.h"
#include "compare/psf/encircled_energy.h"
#include "compare/psf/point_spread.h"
#include "compare/psf/transfer.h"

namespace sturm {

/// What is told of one point spread.
struct PsfSummary {
  Eigen::Vector2d centroid;                                  ///< [arcmin]
  Eigen::Matrix2d covariance;                                ///< [arcmin²]
  WithError radius_50, radius_80;                            ///< of encircled energy [arcmin]
  std::vector<WithError> encircled_energy;                   ///< at the radii of the comparison
  std::array<std::vector<std::optional<WithError>>, 4> mtf;  ///< by direction, at `report_frequencies_cpd`
};

/// Two point spreads side by side.
struct PsfComparison {
  PsfSummary test, reference;
  std::vector<double> radii_arcmin;  ///< 0.1 … 2.0 times the reference's radius of 50 %, where it is above zero
  Eigen::Vector2d shift;             ///< centroid of the test minus that of the reference [arcmin]

  // Distances of the shapes: each spread is about its own centroid.
  TotalVariation total_variation;  ///< on cells of `cell_arcmin`
  double cell_arcmin = 0.0;
  double sliced_wasserstein = 0.0;      ///< [arcmin]
  double largest_mtf_difference = 0.0;  ///< over the directions and frequencies that both tell
};

/// `cell_arcmin` > 0: cells of the total variation.
PsfComparison compare_psfs(const PointSpread& test, const PointSpread& reference, double cell_arcmin);

}  // namespace sturm
