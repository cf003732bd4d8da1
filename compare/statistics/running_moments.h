#pragma once
#include <cmath>

namespace sturm {

/// Mean and scatter of numbers that come one by one (Welford 1962): none of them is kept, and none loses digits to a
/// large mean.
class RunningMoments {
 public:
  void add(double value) {
    const double step = value - mean_;
    mean_ += step / ++count_;
    squares_ += step * (value - mean_);
  }

  double mean() const { return mean_; }

  /// Sample standard deviation of a single number; needs two.
  double deviation() const { return std::sqrt(squares_ / (count_ - 1)); }

 private:
  int count_ = 0;
  double mean_ = 0.0, squares_ = 0.0;
};

}  // namespace sturm
