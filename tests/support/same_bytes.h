#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>

#include "io/images/image.h"

namespace sturm::testing {

/// Whether two pictures are the same bit for bit.
inline bool same_bytes(const Image& a, const Image& b) {
  return std::ranges::equal(a.pixels, b.pixels, [](float x, float y) {
    return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
  });
}

}  // namespace sturm::testing
