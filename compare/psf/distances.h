#pragma once
#include <Eigen/Core>
#include <optional>

#include "compare/psf/point_spread.h"

namespace sturm {

/// Total-variation distance of two point spreads on a common grid.
struct TotalVariation {
  double value = 0.0;  ///< ½ Σ |p − q| over the cells, in [0, 1]

  /// What independent rays of equal expectation would give on average, ½ Σ √(2/π)·σ of each cell's difference, σ from
  /// the mean of both: a distance near it says nothing. None where a side's number of rays is not known.
  std::optional<double> expected_of_noise;
};

/// Cells are squares of `cell_arcmin` > 0 with a corner at the origin; positions count (shift the spreads by their
/// centroids first if only the shape is asked for).
TotalVariation total_variation(const PointSpread& p, const PointSpread& q, double cell_arcmin);

/// Mean over `directions` ≥ 1 evenly spaced directions (from 0°, below 180°) of the 1-D Wasserstein distance W₁ of the
/// projections [arcmin]: how far light has to go on average, seen from the side. Copies shifted by s have 2|s|/π in the
/// limit of many directions.
double sliced_wasserstein(const PointSpread& p, const PointSpread& q, int directions = 64);

/// W₁ of the projections on `direction` (a unit vector) [arcmin]: ∫ |F_p − F_q|.
double projected_wasserstein(const PointSpread& p, const PointSpread& q, const Eigen::Vector2d& direction);

}  // namespace sturm
