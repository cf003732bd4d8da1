#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// Running mean and sum of squared deviations of one pixel's radiance in double (Welford 1962), so that neither 2²⁴
/// samples nor values from 1e−8 to 1e8 in one image lose anything.
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

  /// As if the other's samples had been added too, but for rounding (Chan, Golub & LeVeque 1979).
  void merge(const PixelStatistics& other) {
    if (other.count_ == 0) return;
    const double n = static_cast<double>(count_), m = static_cast<double>(other.count_);
    for (int k = 0; k < 3; ++k) {
      const double difference = other.mean_[k] - mean_[k];
      mean_[k] += difference * (m / (n + m));
      squares_[k] += other.squares_[k] + difference * difference * (n * m / (n + m));
    }
    count_ += other.count_;
  }

  std::uint64_t count() const { return count_; }
  double mean(int channel) const { return mean_[channel]; }

  /// Sample variance of a single sample; 0 with fewer than two samples. Of low-discrepancy samples it is *not* N times
  /// the variance of their mean (docs/theory.md#73-noise-of-a-picture).
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

  /// Nearest planar distance [m] that was seen; ∞ where nothing was hit. Not a mean: across an edge it would lie where
  /// nothing is.
  float depth() const { return nearest_; }

 private:
  std::uint64_t count_ = 0;
  double albedo_[3] = {0.0, 0.0, 0.0}, normal_[3] = {0.0, 0.0, 0.0};
  float nearest_ = std::numeric_limits<float>::infinity();
};

/// Means of what the camera rays of a pixel met first, with the variances of these means: what tells a denoiser an edge
/// from the noise of a pupil that sees several things at once. Features: albedo (3), normal (3, world), vergence
/// 1/distance [1/m]; a miss counts as 0 in all.
class GuideStatistics {
 public:
  static constexpr int features = 7;

  void add(const Eigen::Vector3f& albedo, const Eigen::Vector3f& normal, float distance) {
    ++count_;
    for (int k = 0; k < 3; ++k) {
      add_feature(k, static_cast<double>(albedo[k]));
      add_feature(3 + k, static_cast<double>(normal[k]));
    }
    add_feature(6, 1.0 / static_cast<double>(distance));
  }
  void add_miss() {
    ++count_;
    for (int k = 0; k < features; ++k) add_feature(k, 0.0);
  }

  double mean(int feature) const { return mean_[feature]; }

  /// Sample variance over the number of samples; of low-discrepancy samples this is more than the mean has. 0 with
  /// fewer than two.
  double variance_of_mean(int feature) const {
    return count_ > 1 ? squares_[feature] / static_cast<double>(count_ - 1) / static_cast<double>(count_) : 0.0;
  }

 private:
  void add_feature(int k, double value) {
    const double deviation = value - mean_[k];
    mean_[k] += deviation / static_cast<double>(count_);
    squares_[k] += deviation * (value - mean_[k]);
  }

  std::uint64_t count_ = 0;
  double mean_[features] = {}, squares_[features] = {};
};

}  // namespace sturm
