#pragma once
#include <cstdint>
#include <optional>

#include "io/images/picture_format.h"

namespace sturm {

/// Width and height that a picture claims to have.
struct ClaimedSize {
  std::uint64_t width = 0, height = 0;
};

/// The claim of a picture's header, for formats whose readers make room for all pixels while they open a file: JPEG,
/// BMP, GIF, WebP, HEIF and JPEG 2000. None for the others. Throws std::runtime_error where the header breaks off.
std::optional<ClaimedSize> claimed_size(const PictureFormat& format, const BytesAt& bytes_at);

}  // namespace sturm
