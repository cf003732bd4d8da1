#pragma once
#include <array>
#include <string>

#include "io/images/image.h"

namespace sturm {

/// sRGB-encoded red, green, blue, each k/255 for a whole k (so 8-bit encoding is exact).
using DisplayColour = std::array<float, 3>;

/// Perceptually uniform, dark to light, for t in [0, 1] (clamped): "inferno" of S. van der Walt and N. Smith
/// (matplotlib, CC0), linear between 52 of its 256 entries (at most 2/255 away from them).
DisplayColour sequential_colour(double t);

/// Blue (−1) over near-white (0) to red (+1), clamped: ColorBrewer's 11-class RdBu by C. Brewer, linear in between.
DisplayColour diverging_colour(double t);

/// What a pixel gets whose value is not finite: green, which neither map contains.
DisplayColour not_finite_colour();

/// As "#rrggbb", for markup and plot scripts.
std::string hex_colour(const DisplayColour& colour);

struct SequentialScale {
  double peak = 1.0;  ///< value that gets the lightest colour; > 0
  double decades =
      0.0;  ///< 0: linear from 0 to `peak`; otherwise logarithmic over that many powers of ten below `peak`
};

/// Position of `value` on the scale, [0, 1].
double position_on(const SequentialScale& scale, double value);

/// One-channel `values` in false colour: 3 channels, display-referred. Throws std::invalid_argument unless there is
/// exactly one channel.
Image sequential_false_colour(const Image& values, const SequentialScale& scale);

/// One-channel signed `values`, ±`limit` (> 0) at the ends of the diverging map.
Image diverging_false_colour(const Image& values, double limit);

}  // namespace sturm
