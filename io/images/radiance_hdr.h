#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/images/colour_primaries.h"
#include "io/images/image.h"

namespace sturm {

/// A picture in Radiance's format (.hdr, .pic), upright: row 0 at the top, whichever of the eight orders its scan lines
/// have.
struct RadianceHdr {
  Image image;  ///< 3 channels, linear: what stands in the file, divided by its EXPOSURE and COLORCORR
  std::optional<ColourPrimaries> primaries;  ///< of the header; none: as the format has it, taken as Rec. 709
  std::vector<std::string> notes;            ///< what was divided
};

/// Whether the bytes of a file begin as a Radiance picture does.
bool is_radiance_hdr(std::string_view bytes);

/// Reads one from the bytes of a file [Ward, Larson and Shakespeare 1998, "Picture file format", filefmts.pdf]: flat,
/// old and new run lengths, 32-bit_rle_rgbe. A value is m · 2^(e − 136). Throws std::runtime_error for what breaks off,
/// does not fit together, or has more than `max_pixels`.
RadianceHdr decode_radiance_hdr(std::string_view bytes, std::size_t max_pixels);

}  // namespace sturm
