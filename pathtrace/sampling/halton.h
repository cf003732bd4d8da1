#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "pathtrace/sampling/owen_sobol.h"

namespace sturm {

/// Halton's sequence with nested random digit shifts: coordinate k is the radical inverse in the k-th prime, each digit
/// shifted by a number that depends on the digits before it (Owen's scrambling restricted to shifts). Addressed like
/// owen_sobol, no faster: for comparison with renderers that use Halton's points.
namespace halton {

/// Later dimensions take these again under other keys, as padding does.
inline constexpr std::array<std::uint32_t, 32> primes{2,  3,  5,  7,   11,  13,  17,  19,  23,  29, 31,
                                                      37, 41, 43, 47,  53,  59,  61,  67,  71,  73, 79,
                                                      83, 89, 97, 101, 103, 107, 109, 113, 127, 131};

/// The scrambled radical inverse of `index` in `base`, uniform in [0, 2³²). The first 2¹⁶ points are stratified digit
/// by digit; beyond, only the digits that the index has. What follows is random.
inline std::uint32_t scrambled_radical_inverse(std::uint32_t index, std::uint32_t base, std::uint32_t key) {
  double value = 0.0, place = 1.0;
  std::uint32_t prefix = key;
  for (std::uint32_t reach = 1; reach < (1u << 16) || index > 0; reach = reach < (1u << 16) ? reach * base : reach) {
    const std::uint32_t hash = owen_sobol::mixed(prefix);
    const std::uint32_t digit = (index % base + hash % base) % base;
    index /= base;
    place /= base;
    value += digit * place;
    prefix = owen_sobol::combined(hash, digit + 1u);
  }
  value += place * unit_double(owen_sobol::mixed(prefix));
  return static_cast<std::uint32_t>(std::min(value, 1.0 - 0x1p-33) * 0x1p32);
}

/// The pair of coordinates that starts at a dimension; a dimension's second coordinate has the next prime.
inline owen_sobol::Pair pair(std::uint32_t index, std::uint32_t dimension, const owen_sobol::Keys& keys) {
  const std::uint32_t first = 2u * dimension % static_cast<std::uint32_t>(primes.size());
  return {scrambled_radical_inverse(index, primes[first], keys.x),
          scrambled_radical_inverse(index, primes[first + 1u], keys.y)};
}

}  // namespace halton

}  // namespace sturm
