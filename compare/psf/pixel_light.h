#pragma once
#include <Eigen/Core>
#include <vector>

#include "compare/psf/pixel_gaussian.h"
#include "compare/psf/point_spread.h"

namespace sturm {

/// The light of a picture of a point as a function of the place, for areas that cut through pixels.
///
/// A pixel has gathered light over its area, so that pixels are samples of the spot widened by a square (variance
/// side²/12 along either axis). Light that is spread evenly over each pixel would widen the spot by as much again and
/// depend on where the spot lies in its pixel: 4 % of the radius of half the energy of a Gaussian with σ = one pixel.
/// The samples are therefore joined by the quintic spline through them, which adds no variance; Unser, Splines: A
/// perfect fit (1999). A spline cannot follow spots with σ below a pixel, so it only has what a Gaussian along both
/// axes leaves of them, whose light is known exactly.
class PixelLight {
 public:
  /// `spread` is a picture: its points lie on a grid of `cell_arcmin` > 0.
  explicit PixelLight(const PointSpread& spread);

  /// Share of the light within `radius` [arcmin] of the centroid, from 0 to 1. Pixels on the circle count by the exact
  /// areas of their 8 × 8 parts within it.
  double within(double radius_arcmin) const;

  /// A radius [arcmin], to rounding, with the share `energy` in (0, 1) of the light.
  double radius_of(double energy) const;

 private:
  struct Cell {
    double distance;  ///< of its middle from the centroid [pixels]
    double light;
    int x, y;
  };

  double light_on_circle(const Cell& cell, double radius) const;
  double share(double radius) const;

  double side_arcmin_;
  Eigen::Vector2d centroid_;              ///< [pixels] from the middle of cell (0, 0)
  std::vector<PixelGaussian> gaussians_;  ///< along x and y; cell (0, 0) is at 0
  Eigen::MatrixXd
      coefficients_;         ///< of the spline through what they leave, by cell; with a margin in which it dies out
  std::vector<Cell> cells_;  ///< sorted by distance
  std::vector<double> light_before_;  ///< sums of the cells before each
};

}  // namespace sturm
