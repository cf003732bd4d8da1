#pragma once
#include <array>

#include "io/images/image.h"

namespace sturm {

/// L*, a*, b*.
using Lab = std::array<double, 3>;

/// CIE colour difference ΔE₀₀ with k_L = k_C = k_H = 1 (CIE 142-2001), by the steps and with the rules for hues of
/// [Sharma2005].
double ciede2000_difference(const Lab& first, const Lab& second);

/// ΔE₀₀ of two pictures. About 1 is just noticeable for large patches side by side; there is no spatial filter in it.
struct Ciede2000 {
  double mean = 0.0;  ///< over the pixels
  Image map;          ///< one channel
};

/// Of display values (sRGB in [0, 1], 3 channels) under D65. Throws InputError as `require_comparable`, and for other
/// than 3 channels.
Ciede2000 ciede2000(const Image& test, const Image& reference);

}  // namespace sturm
