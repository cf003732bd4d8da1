#pragma once
#include <Eigen/Core>
#include <optional>

#include "io/images/image.h"
#include "lensmodel/ellipse.h"

namespace sturm {

/// What turns pixels into slopes, and what the emitter adds to the spot.
struct SpotImaging {
  double pixel_slope = 1.0;  ///< width of a (square) pixel as a slope (tangent), > 0
  Eigen::Vector2d axis_px =
      Eigen::Vector2d::Zero();  ///< where slope (0, 0) falls, in pixels; (width/2, height/2) for a centred camera
  Eigen::Matrix2d emitter_covariance =
      Eigen::Matrix2d::Zero();  ///< of the emitter's own shape as a slope², wearer frame (y up)
};

/// Ellipse of the image of a point-like emitter. Pixel coordinates run right and **down** from the image's top left
/// corner, the centre of pixel (0, 0) is (0.5, 0.5); slopes are in the wearer frame (x right, y **up**).
struct ImageEllipse {
  Eigen::Vector2d centroid_px;
  Eigen::Matrix2d covariance_px;  ///< [px²], pixel axes; pixel box and emitter taken off
  Eigen::Vector2d centroid;       ///< slope
  Eigen::Matrix2d covariance;     ///< slope²
  Ellipse ellipse;                ///< of second moments, slope; orientation in the wearer frame
  std::optional<Eigen::Vector2d> centroid_standard_error;  ///< slope; with a variance image only
  std::optional<Eigen::Matrix3d>
      entry_covariance;  ///< of the entries (xx, xy, yy) of `covariance`, slope⁴; with a variance image only
  std::optional<Eigen::Vector2d> semi_axis_standard_errors;  ///< (major, minor), slope
};

/// Weights each pixel by the mean of its channels, without any threshold. `variance_of_mean` (may be null) has the size
/// of the image and holds the variance of each pixel's mean value — between independent replicates: the variance of
/// low-discrepancy samples inside a pixel is not the variance of their mean. Pixels are taken as independent of each
/// other, channels as fully correlated (they share their rays).
///
/// Sampling the spot on a pixel grid adds the variance of the pixel box, 1/12 px² per axis (Sheppard's correction,
/// exact up to aliasing once the spot covers a few pixels). Throws InputError for an empty image, non-finite pixels,
/// sizes that differ, or an image whose sum is not positive (nothing was hit).
ImageEllipse measure_image_ellipse(const Image& image, const Image* variance_of_mean, const SpotImaging& imaging);

}  // namespace sturm
