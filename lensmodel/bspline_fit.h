#pragma once
#include <Eigen/Core>
#include <span>

#include "lensmodel/bspline_surface.h"

namespace sturm {

/// Distances of a fitted surface from the points that it was fitted to, along z [m].
struct FitResidual {
  double rms = 0.0, max = 0.0;
};

/// Of points within the surface's grid, or outside of it by rounding.
FitResidual residual_at(const BSplineSurface& surface, std::span<const Eigen::Vector3d> points);

struct BSplineFit {
  BSplineSurface surface;
  FitResidual residual;
};

/// The B-spline surface on `grid` nearest to points (x, y, z) [m] within it: least squares of the heights plus a very
/// small weight on the fourth differences of the coefficients along x and y. That weight makes the answer unique where
/// points are scarce (the corners outside of a round lens), vanishes for bicubic polynomials, which come back exactly,
/// and pulls a surface that the points determine by less than their own scatter. Throws std::invalid_argument for a
/// point outside of the grid or a number that is not finite, and std::domain_error where the points do not determine a
/// surface at all (fewer than 16, or all on a few lines).
BSplineFit fitted_bspline(const KnotGrid& grid, std::span<const Eigen::Vector3d> points);

}  // namespace sturm
