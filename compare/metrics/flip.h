#pragma once
#include "io/images/image.h"

namespace sturm {

/// Difference that an observer sees who flips between two pictures [Andersson2020], in [0, 1] per pixel.
struct Flip {
  double mean = 0.0;  ///< over the pixels
  Image map;          ///< one channel
};

/// Pixels per degree of the authors' default observer: 0.7 m from a 3840 px wide monitor of 0.7 m.
inline constexpr double flip_default_pixels_per_degree = 67.0206433;

/// Side of the square of pixels that one value of the map depends on.
int flip_window_px(double pixels_per_degree);

/// LDR-FLIP of display values (sRGB in [0, 1], 3 channels): both pictures are filtered with the eye's contrast
/// sensitivities (YCxCz) for `pixels_per_degree` > 0, their distance is HyAB in Hunt-adjusted CIELAB, and differences
/// of edges and points (filters of 0.082°) raise it. The same bits for any number of threads. Throws InputError as
/// `require_colour_pair`.
Flip flip(const Image& test, const Image& reference, double pixels_per_degree);

/// The same of linear light that a display shows as it is: clamped to [0, 1] here.
Flip flip_of_light(const Image& test, const Image& reference, double pixels_per_degree);

}  // namespace sturm
