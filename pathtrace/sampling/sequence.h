#pragma once
#include <array>
#include <cstdint>

#include "io/specs/ray_bundle_spec.h"
#include "pathtrace/sampling/halton.h"
#include "pathtrace/sampling/owen_sobol.h"

namespace sturm {

/// Dimensions of a path; every vertex of a path has its own block.
namespace dimension {
inline constexpr std::uint32_t film = 0, lens = 1, first_vertex = 2, per_vertex = 3;
inline constexpr std::uint32_t scatter = 0, light = 1, survive = 2;
/// Of guided samples, behind all vertices that a path can have.
inline constexpr std::uint32_t guided_film = 1u << 20, guided_lens = guided_film + 1, guided_choice = guided_film + 2;
}  // namespace dimension

/// Pairs of words of `count` consecutive samples.
template <int count>
struct PairBlock {
  alignas(64) std::uint32_t x[count], y[count];
};

/// The samples of one pixel, addressed by (sample, dimension).
class PixelSequence {
 public:
  PixelSequence(Sequence kind, std::uint64_t seed, std::uint32_t pixel)
      : kind_(kind),
        key_(owen_sobol::combined(
            owen_sobol::combined(static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)), pixel)) {}

  Sequence kind() const { return kind_; }

  /// Seeds of the scramblings of a dimension (of the pair that starts there).
  owen_sobol::Keys keys(std::uint32_t dimension) const {
    if (dimension >= cached_dimensions) return owen_sobol::Keys(owen_sobol::combined(key_, dimension));
    for (; known_ <= dimension; ++known_) cache_[known_] = owen_sobol::Keys(owen_sobol::combined(key_, known_));
    return cache_[dimension];
  }

  owen_sobol::Pair pair(std::uint32_t sample, std::uint32_t dimension) const {
    const owen_sobol::Keys k = keys(dimension);
    if (kind_ == Sequence::Halton) return halton::pair(sample, dimension, k);
    return kind_ == Sequence::Sobol ? owen_sobol::pair(sample, k) : independent(sample, k.order);
  }

  /// The pairs of the samples from `first_sample` on, as `pair` gives them; the loop over Sobol' points vectorises.
  template <int count>
  PairBlock<count> pairs(std::uint32_t first_sample, std::uint32_t dimension) const {
    const owen_sobol::Keys k = keys(dimension);
    PairBlock<count> block;
    const auto fill = [&](auto&& pair_of) {
      for (int i = 0; i < count; ++i) {
        const owen_sobol::Pair p = pair_of(first_sample + static_cast<std::uint32_t>(i));
        block.x[i] = p.x;
        block.y[i] = p.y;
      }
    };
    if (kind_ == Sequence::Sobol)
      fill([&](std::uint32_t sample) { return owen_sobol::pair(sample, k); });
    else if (kind_ == Sequence::Halton)
      fill([&](std::uint32_t sample) { return halton::pair(sample, dimension, k); });
    else
      fill([&](std::uint32_t sample) { return independent(sample, k.order); });
    return block;
  }

  std::uint32_t single(std::uint32_t sample, std::uint32_t dimension) const {
    const owen_sobol::Keys k = keys(dimension);
    if (kind_ == Sequence::Halton) return halton::pair(sample, dimension, k).x;
    return kind_ == Sequence::Sobol ? owen_sobol::single(sample, k) : independent(sample, k.order).x;
  }

  /// Two independent 32-bit words for (sample, key).
  static owen_sobol::Pair independent(std::uint32_t sample, std::uint32_t key) {
    const std::uint32_t x = owen_sobol::mixed(owen_sobol::mixed(sample + 0x9e3779b9u) ^ key);
    return {x, owen_sobol::mixed(x ^ owen_sobol::mixed(key + 0x51ed270bu))};
  }

 private:
  static constexpr std::uint32_t cached_dimensions = 32;

  Sequence kind_;
  std::uint32_t key_;
  // All samples of a pixel use the same keys, so the first one to need a dimension leaves them here. One thread works
  // on a pixel.
  mutable std::uint32_t known_ = 0;
  mutable std::array<owen_sobol::Keys, cached_dimensions> cache_;
};

}  // namespace sturm
