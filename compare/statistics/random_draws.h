#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

namespace sturm {

/// SplitMix64 [Steele2014]: full period, and the same numbers everywhere. Advances `state`.
inline std::uint64_t next_random(std::uint64_t& state) {
  std::uint64_t z = state += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// Standard normal deviates by the method of Box and Muller, the same for a seed on every machine up to the rounding of
/// log and cos.
class NormalDraws {
 public:
  explicit NormalDraws(std::uint64_t seed) : state_(seed) {}

  double next() {
    if (second_) {
      const double value = *second_;
      second_.reset();
      return value;
    }
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform())), angle = 2.0 * std::numbers::pi * uniform();
    second_ = radius * std::sin(angle);
    return radius * std::cos(angle);
  }

 private:
  double uniform() { return static_cast<double>(next_random(state_) >> 11) * 0x1p-53; }

  std::uint64_t state_;
  std::optional<double> second_;
};

}  // namespace sturm
