#pragma once
#include <cstdint>

namespace sturm {

/// Addressed random numbers: every value is a function of (seed, pixel, sample, dimension) alone, so any sample can be
/// replayed and the picture does not depend on the number of threads. Padded Owen-scrambled (0,2)-sequences: Burley,
/// "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020, with the bit mixer of Vegdahl (2021). All arithmetic is
/// branch-free on 32-bit words, so that loops over samples vectorise.
namespace owen_sobol {

inline std::uint32_t reversed_bits(std::uint32_t x) {
  x = __builtin_bswap32(x);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
  x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
  return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

/// Owen scrambling in bit-reversed space: bit k of the result depends on the bits 0…k of x only.
inline std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

/// Finaliser of a good 32-bit hash (lowbias32, Wellons 2018).
inline std::uint32_t mixed(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  return x ^ (x >> 16);
}

inline std::uint32_t combined(std::uint32_t a, std::uint32_t b) {
  return mixed(a ^ (b * 0x9e3779b9u + 0x85ebca6bu));
}

/// The second Sobol dimension in bit-reversed space: multiplication by Pascal's triangle modulo 2.
inline std::uint32_t second_dimension(std::uint32_t x) {
  x ^= (x >> 16);
  x ^= (x & 0xff00ff00u) >> 8;
  x ^= (x & 0xf0f0f0f0u) >> 4;
  x ^= (x & 0xccccccccu) >> 2;
  return x ^ ((x & 0xaaaaaaaau) >> 1);
}

struct Pair {
  std::uint32_t x, y;  ///< uniform in [0, 2³²)
};

/// Seeds of the three scramblings of a pair of dimensions: of the order of the samples, and of either coordinate.
struct Keys {
  std::uint32_t order, x, y;

  Keys() = default;
  explicit Keys(std::uint32_t key) : order(key), x(mixed(key ^ 0x68bc21ebu)), y(mixed(key ^ 0x02e5be93u)) {}
};

/// Sample `index` of the pair of dimensions with these keys.
inline Pair pair(std::uint32_t index, const Keys& keys) {
  const std::uint32_t shuffled = reversed_bits(scrambled(reversed_bits(index), keys.order));
  return {reversed_bits(scrambled(shuffled, keys.x)), reversed_bits(scrambled(second_dimension(shuffled), keys.y))};
}

inline Pair pair(std::uint32_t index, std::uint32_t key) {
  return pair(index, Keys(key));
}

/// Sample `index` of a single dimension.
inline std::uint32_t single(std::uint32_t index, const Keys& keys) {
  const std::uint32_t shuffled = reversed_bits(scrambled(reversed_bits(index), keys.order));
  return reversed_bits(scrambled(shuffled, keys.x));
}

inline std::uint32_t single(std::uint32_t index, std::uint32_t key) {
  return single(index, Keys(key));
}

}  // namespace owen_sobol

/// Uniform in [0, 1): the largest result is 1 − 2⁻²⁴, so that 1 never appears.
inline float unit_float(std::uint32_t x) {
  return static_cast<float>(static_cast<std::int32_t>(x >> 8)) * 0x1p-24f;
}

/// Uniform in (0, 1), centred in its cell of 2⁻³².
inline double unit_double(std::uint32_t x) {
  return (static_cast<double>(x) + 0.5) * 0x1p-32;
}

}  // namespace sturm
