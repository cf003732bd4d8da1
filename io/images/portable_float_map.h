#pragma once
#include <string_view>

#include "io/images/image.h"

namespace sturm {

/// Whether the bytes of a file begin as a portable float map does: "PF" or "Pf".
bool is_portable_float_map(std::string_view bytes);

/// Reads a portable float map (.pfm) [Debevec, "PFM portable float map"] from the bytes of a file: 3 channels ("PF") or
/// 1 ("Pf"), rows from the bottom up, big-endian, or little-endian where the scale is negative. Its size is a factor of
/// the values, unless `as_stored`: maps of disparities state something else by it. Throws std::runtime_error for what
/// breaks off, is no such picture, or has more than `max_pixels`.
Image decode_portable_float_map(std::string_view bytes, std::size_t max_pixels, bool as_stored = false);

}  // namespace sturm
