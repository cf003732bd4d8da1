#pragma once
#include <cstring>

#include "io/images/image.h"

namespace sturm::testing {

/// Whether two pictures are the same bit for bit.
inline bool same_bytes(const Image& a, const Image& b) {
  return a.pixels.size() == b.pixels.size() &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

}  // namespace sturm::testing
