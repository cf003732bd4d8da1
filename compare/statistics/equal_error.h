#pragma once
#include <optional>

namespace sturm {

/// What a picture of some samples per pixel cost and how noisy it was.
struct MeasuredNoise {
  double samples = 0.0, seconds = 0.0;
  double variance = 0.0;  ///< of a single picture, mean square
};

/// Time and noise of path tracing as functions of the samples per pixel, from two measured numbers of them, fewer <
/// more: variance ∝ n^−order (1 of independent samples, more of well-distributed ones where blur is smooth), seconds
/// affine in n.
class NoiseOverTime {
 public:
  NoiseOverTime(const MeasuredNoise& fewer, const MeasuredNoise& more) : fewer_(fewer), more_(more) {}

  /// None where noise did not fall.
  std::optional<double> order() const;

  /// Samples per pixel whose variance is `variance` > 0; none without an order.
  std::optional<double> samples_for(double variance) const;
  std::optional<double> variance_of(double samples) const;

  /// Where the line through both would start below 0 s (times of few samples scatter): in proportion to n, through
  /// `more`.
  double seconds_for(double samples) const;

  double seconds_per_sample() const { return (more_.seconds - fewer_.seconds) / (more_.samples - fewer_.samples); }

 private:
  MeasuredNoise fewer_, more_;
};

}  // namespace sturm
