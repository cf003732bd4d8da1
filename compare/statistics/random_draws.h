#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

namespace sturm {

/// 2^64 over the golden ratio: what SplitMix64 adds to its state.
inline constexpr std::uint64_t golden_step = 0x9e3779b97f4a7c15u;

/// The output function of SplitMix64 [Steele2014]: every bit of `z` changes about half of the bits of the result.
inline std::uint64_t mixed_bits(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// SplitMix64: full period, and the same numbers everywhere. Advances `state`.
inline std::uint64_t next_random(std::uint64_t& state) {
  return mixed_bits(state += golden_step);
}

/// A number in [0, 1) made of the upper 53 bits.
inline double unit_interval(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
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
  double uniform() { return unit_interval(next_random(state_)); }

  std::uint64_t state_;
  std::optional<double> second_;
};

}  // namespace sturm
