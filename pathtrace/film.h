#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "io/image.h"

namespace sturm {

/// Running mean and sum of squared deviations of one pixel's radiance in double (Welford 1962), so that neither 2²⁴ samples nor values
/// from 1e−8 to 1e8 in one image lose anything.
class PixelStatistics {
 public:
  void add(const Eigen::Vector3f& radiance) {
    ++count_;
    const double weight = 1.0 / static_cast<double>(count_);
    for (int k = 0; k < 3; ++k) {
      const double deviation = static_cast<double>(radiance[k]) - mean_[k];
      mean_[k] += deviation * weight;
      squares_[k] += deviation * (static_cast<double>(radiance[k]) - mean_[k]);
    }
  }

  std::uint64_t count() const { return count_; }
  double mean(int channel) const { return mean_[channel]; }

  /// Sample variance of a single sample; 0 with fewer than two samples. Of low-discrepancy samples it is *not* N times the variance of
  /// their mean (physics.md §8).
  double variance(int channel) const { return count_ > 1 ? squares_[channel] / static_cast<double>(count_ - 1) : 0.0; }

 private:
  std::uint64_t count_ = 0;
  double mean_[3] = {0.0, 0.0, 0.0}, squares_[3] = {0.0, 0.0, 0.0};
};

/// What the camera rays of a pixel met first; for the auxiliary layers.
class FirstHitStatistics {
 public:
  void add(const Eigen::Vector3f& albedo, const Eigen::Vector3f& normal, float planar_depth) {
    ++count_;
    for (int k = 0; k < 3; ++k) {
      albedo_[k] += albedo[k];
      normal_[k] += normal[k];
    }
    nearest_ = std::min(nearest_, planar_depth);
  }
  void add_miss() { ++count_; }

  double albedo(int channel) const { return count_ ? albedo_[channel] / static_cast<double>(count_) : 0.0; }
  double normal(int channel) const { return count_ ? normal_[channel] / static_cast<double>(count_) : 0.0; }

  /// Nearest planar distance [m] that was seen; ∞ where nothing was hit. Not a mean: across an edge it would lie where nothing is.
  float depth() const { return nearest_; }

 private:
  std::uint64_t count_ = 0;
  double albedo_[3] = {0.0, 0.0, 0.0}, normal_[3] = {0.0, 0.0, 0.0};
  float nearest_ = std::numeric_limits<float>::infinity();
};

}  // namespace sturm
