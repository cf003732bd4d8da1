#pragma once
#include <array>

namespace sturm {

/// The wavelengths that stand for the channels R, G and B of a picture [nm]: the dominant ones of sRGB's primaries.
inline constexpr std::array<double, 3> primary_wavelengths_nm = {612.0, 549.0, 464.0};

}  // namespace sturm
