#pragma once
#include <cmath>
#include <cstdint>

namespace sturm::stress {

/// The random numbers of one case, addressed by (seed, case). SplitMix64 [Steele2014]; needs no more quality than
/// spreading the cases.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t index) : state_(mixed(mixed(seed) ^ (index + 1) * 0x9E3779B97F4A7C15ull)) {}

  std::uint64_t bits() { return mixed(state_ += 0x9E3779B97F4A7C15ull); }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  ///< [0, 1)
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
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace sturm::stress
