#pragma once
#include <algorithm>

#include "io/images/image.h"

namespace sturm {

inline float brightness_of(const float* rgb) {
  return std::max({rgb[0], rgb[1], rgb[2]});
}

/// So many times the median of a picture's brightness, and at least that of all but one pixel in twenty.
float bright_level(const Image& radiance, float medians);

}  // namespace sturm
