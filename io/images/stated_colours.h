#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/images/image.h"
#include "io/images/picture_format.h"

namespace sturm {

/// What a file says of the numbers of its picture.
struct StatedColours {
  std::optional<double> gamma;     ///< light is the stored integer (0 … 1) to this power; none: sRGB's curve
  std::vector<std::string> notes;  ///< what is stated and not followed
};

/// Of a PNG: the first of `cICP`, an embedded profile, `sRGB` and `gAMA` with `cHRM` counts [PNG, third edition, 4.3].
/// A gamma within 2 % of 1/2.2 is sRGB's, as encoders write it. A profile is left to `note_of_profile`.
StatedColours colours_of_png(const BytesAt& bytes_at);

/// What is to be noted of an embedded ICC profile that is not applied: nothing if it is sRGB's (of integers) or has
/// Rec. 709's primaries and no curve (of floats).
std::optional<std::string> note_of_profile(std::span<const unsigned char> profile, bool of_integers);

/// Integers of a picture for a display in linear light; the last of 2 or 4 channels is alpha and stays as it is.
Image decoded_light(const Image& stored, const StatedColours& colours);

}  // namespace sturm
