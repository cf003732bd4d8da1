#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "io/images/image.h"
#include "io/images/picture_format.h"

namespace sturm {

/// What libpng finds in a PNG file.
struct StoredPng {
  Image image;  ///< channels and values as stored, integers as 0…1; palettes as colours, transparent colours as alpha
  int bits = 0;         ///< of a channel
  std::string profile;  ///< ICC, or empty
};

/// Reads a PNG file with at most so many pixels; room is made for rows that are there, and for all of an interlaced
/// picture. Nothing for files that say more in EXIF or XMP, e.g. which side is up. Throws std::runtime_error about what
/// is wrong with a file.
std::optional<StoredPng> read_png(const BytesAt& bytes_at, std::uint64_t most_pixels);

}  // namespace sturm
