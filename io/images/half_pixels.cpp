#include "io/images/half_pixels.h"

#include <Imath/half.h>

namespace sturm {

std::vector<unsigned char> half_float_bytes(std::span<const float> values) {
  std::vector<unsigned char> bytes;
  bytes.reserve(2 * values.size());
  for (const float value : values) {
    const unsigned bits = half(value).bits();
    bytes.push_back(static_cast<unsigned char>(bits & 255));
    bytes.push_back(static_cast<unsigned char>(bits >> 8));
  }
  return bytes;
}

}  // namespace sturm
