#pragma once
#include <span>
#include <string>

namespace sturm {

/// How light becomes numbers.
enum class IccCurve { Srgb, Linear, Other };

/// What an ICC profile says of a picture, as far as it takes to tell sRGB from others.
struct IccProfile {
  std::string name;                   ///< its description, in whatever encoding; empty if there is none
  bool has_rec709_primaries = false;  ///< or is one of grey pictures
  IccCurve curve = IccCurve::Other;
};

/// Reads a profile with a matrix and curves [ICC.1:2022]; one that breaks off or has tables is of other colours.
IccProfile read_icc_profile(std::span<const unsigned char> bytes);

}  // namespace sturm
