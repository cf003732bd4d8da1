#pragma once
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

/// What an à-trous B3 spline filter leaves of independent noise on a flat field.
namespace sturm::testing {

inline constexpr double b3_taps[5] = {0.0625, 0.25, 0.375, 0.25, 0.0625};

/// Squared norm of the kernel of some levels without edge stopping, in one dimension: (1, 4, 6, 4, 1)/16 with gaps of
/// 1, 2, 4 … put one after the other. Its square is what is left of the variance: (70/256)² = 0.0748 after one level.
inline double squared_norm(int levels) {
  std::vector<double> kernel{1.0};
  for (int level = 0; level < levels; ++level) {
    const std::size_t step = std::size_t{1} << level;
    std::vector<double> next(kernel.size() + 4 * step, 0.0);
    for (std::size_t i = 0; i < kernel.size(); ++i)
      for (std::size_t j = 0; j < 5; ++j) next[i + j * step] += b3_taps[j] * kernel[i];
    kernel = next;
  }
  double sum = 0.0;
  for (const double k : kernel) sum += k * k;
  return sum;
}

/// Part of the variance that one level leaves of uniform noise where a tap that differs by d standard deviations counts
/// `falloff`(d²) of its weight: the mean over draws of 25 taps.
template <class Falloff>
double left_by_falloff(const Falloff& falloff, int draws = 50000) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> noise(-std::sqrt(3.0), std::sqrt(3.0));
  double squares = 0.0;
  for (int k = 0; k < draws; ++k) {
    const double own = noise(random);
    double sum = 0.0, weights = 0.0;
    for (int tap = 0; tap < 25; ++tap) {
      const double value = tap == 12 ? own : noise(random), d = value - own;
      const double weight = b3_taps[tap % 5] * b3_taps[tap / 5] * falloff(d * d);
      sum += weight * value;
      weights += weight;
    }
    squares += sum * sum / (weights * weights) / draws;
  }
  return squares;
}

/// The same for the falloff exp(−d²/(2·width²)). Without limit on the taps the middle value x keeps x/(1 + width²) (a
/// normal density times the weight has its mean there), which is what edge stopping adds to the norm of the kernel:
/// 1/(1 + width²)².
inline double left_with_edge_stopping(double width) {
  return left_by_falloff([width](double d2) { return std::exp(-d2 / (2.0 * width * width)); });
}

}  // namespace sturm::testing
