#pragma once
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// PNG of a display-referred image (0…1, 1 or 3 channels; values are clamped and rounded to nearest) with 8 or 16 bits,
/// marked as sRGB. Throws std::invalid_argument for other channel counts and bits, empty images and non-finite values,
/// RuntimeFailure if libpng refuses.
std::vector<unsigned char> encode_png(const Image& display, int bits = 8);

}  // namespace sturm
