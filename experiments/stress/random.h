#pragma once
#include <cmath>
#include <cstdint>

#include "compare/statistics/random_draws.h"

namespace sturm::stress {

/// The random numbers of one case, addressed by (seed, case); they need no more quality than spreading the cases.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t index) : state_(mixed_bits(mixed_bits(seed) ^ (index + 1) * golden_step)) {}

  std::uint64_t bits() { return next_random(state_); }
  double unit() { return unit_interval(bits()); }  ///< [0, 1)
  double uniform(double low, double high) { return low + (high - low) * unit(); }
  double log_uniform(double low, double high) { return low * std::pow(high / low, unit()); }
  double either_sign(double x) { return chance(0.5) ? x : -x; }
  bool chance(double p) { return unit() < p; }
  int below(int n) { return static_cast<int>(unit() * n); }

  /// Uniform on a grid, as prescriptions are written (0.25 D, 1 degree).
  double stepped(double low, double high, double step) {
    return low + step * std::floor(unit() * (std::floor((high - low) / step) + 1.0));
  }

 private:
  std::uint64_t state_;
};

}  // namespace sturm::stress
