#pragma once
#include <array>

namespace sturm {

/// The wavelength that an eye's wavefront or prescription is taken to be in focus at [nm]: the peak of daylight vision.
inline constexpr double focus_wavelength_nm = 555.0;

/// The wavelengths that stand for the channels R, G and B of a picture [nm]: the dominant ones of sRGB's primaries.
inline constexpr std::array<double, 3> primary_wavelengths_nm = {612.0, 549.0, 464.0};

}  // namespace sturm
