#pragma once
#include <optional>
#include <vector>

#include "compare/images/image_comparison.h"

namespace sturm {

/// What noise alone makes of a metric, from pictures of the same views with other seeds.
struct NoiseFloor {
  std::optional<double>
      value;  ///< the metric between two seeds of one view; with both views twice: the worse of the two

  /// Deviation of the comparison from the floor as a normal deviate, positive where the pictures differ more than seeds
  /// do. None where it cannot be told (fewer than two blocks, a metric without a value there, a trimmed mean).
  std::optional<double> z;
};

/// Compares the local values of `metric` with those of the same metric between seeds (one or two of them), inside a
/// mask or everywhere.
///
/// If test and reference have the same expectation and the same noise, exchanging a second seed of the test for the
/// reference changes nothing: the difference of the two maps is symmetric about 0, whatever the metric. It is summed
/// over blocks of 32 × 32 pixels, or twice the metric's window where that is more (352 for MS-SSIM), so that
/// neighbouring blocks are nearly independent, and z is Student's t of the block sums (ratio estimator, as many degrees
/// of freedom as blocks less one) turned into a normal deviate. With seeds of both views the floor is the mean of their
/// two maps, which for squared errors holds for unequal noise too.
NoiseFloor noise_floor(const ImageMetric& metric, const std::vector<const ImageMetric*>& between_seeds,
                       const Image* mask = nullptr);

}  // namespace sturm
