#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// A point spread function as weighted points: where light goes, in arcminutes, wearer frame (x right, y up). What a
/// ray bundle, a picture of a point and a predicted ellipse have in common; each measure of compare/psf/ takes two of
/// them.
struct PointSpread {
  std::vector<Eigen::Vector2d> points;  ///< [arcmin]
  std::vector<double> weights;          ///< ≥ 0, they add up to 1

  /// Side of the square that each point stands for [arcmin]: a pixel; 0 for rays.
  double cell_arcmin = 0.0;

  /// Number of independent rays that the points stand for; 0 where it is not random or not known. Standard errors
  /// follow from it.
  double independent_rays = 0.0;

  Eigen::Vector2d centroid() const;  ///< [arcmin]
  Eigen::Matrix2d covariance()
      const;  ///< about the centroid [arcmin²]; the variance of the cells, side²/12 per axis, is taken off (Sheppard)

  /// The same points about their own centroid.
  PointSpread centred() const;
};

/// Rays of equal weight, as angles [rad]. `independent`: they are independent of each other (not low-discrepancy
/// points, whose scatter is smaller and not known from one set). Throws std::invalid_argument for an empty list.
PointSpread spread_of_rays(std::span<const Eigen::Vector2d> angles_rad, bool independent);

/// Rays with weights ≥ 0 of positive sum; independent, worth (Σw)²/Σw² rays of equal weight.
PointSpread spread_of_rays(std::span<const Eigen::Vector2d> angles_rad, std::span<const double> weights);

/// The image of a small emitter: every pixel weighs the mean of its channels. Row 0 is at the top; the origin is the
/// picture's centre. `pixel_arcmin` > 0. Throws InputError for an image that is not finite or whose sum is not
/// positive.
PointSpread spread_of_image(const Image& image, double pixel_arcmin);

/// Uniform density over the ellipse `map`·(disc of radius `radius_m`), `map` in [rad/m], as `count` ≥ 1 points of equal
/// weight on a sunflower (Vogel's spiral): error O(1/count) in second moments.
PointSpread spread_of_ellipse(const Eigen::Matrix2d& map, double radius_m, int count);

}  // namespace sturm
