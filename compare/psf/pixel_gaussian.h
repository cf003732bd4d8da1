#pragma once
#include <Eigen/Core>

namespace sturm {

/// A Gaussian along one axis, and what pixels of side 1 gather of it.
class PixelGaussian {
 public:
  /// The one whose pixels have the same mean and variance as `light`: of pixels in a row with their middles at 0, 1, …,
  /// adding up to 1. Of spots that are much smaller than a pixel the pixels do not tell the deviation; it is at least
  /// 0.05.
  explicit PixelGaussian(const Eigen::VectorXd& light);

  /// Light of a pixel with its middle at `place`; as a function of the place, the density of the Gaussian widened by a
  /// pixel.
  double pixel(double place) const;

  /// Light of that density within `width` about `place`.
  double light(double place, double width) const;

 private:
  void match(double mean, double variance);

  double middle_, deviation_;
};

}  // namespace sturm
