#pragma once
#include "compare/metrics/flip.h"
#include "io/images/image.h"

namespace sturm {

/// Exposures 2^start … 2^stop that an HDR picture is looked at with.
struct ExposureRange {
  double start_stops = 0.0, stop_stops = 0.0;  ///< powers of two, start ≤ stop
  int count = 1;                               ///< ≥ 1, evenly spaced in powers of two

  double stops(int i) const {
    return count == 1 ? start_stops : start_stops + i * (stop_stops - start_stops) / (count - 1);
  }  ///< exposure i of 0 … count − 1, as a power of two
};

/// The range for a reference picture by the rule of [Andersson2021]: at the shortest exposure the brightest pixel, at
/// the longest the median luminance comes out at 0.85 of the tone map; max(2, ⌈stop − start⌉) exposures. Left to this
/// project: the median is that of pixels with a luminance above zero, there are at most 16 exposures (beyond 16 stops
/// they lie further apart), and a black picture gets the one exposure 1.
ExposureRange hdr_flip_exposures(const Image& reference);

/// HDR-FLIP [Andersson2021]: the largest LDR-FLIP of each pixel over the exposures, after the ACES tone curve (fit of
/// K. Narkowicz with its exposure of 0.6). Linear light, 3 channels, negative values count as 0. Throws InputError as
/// `require_colour_pair`.
Flip hdr_flip(const Image& test, const Image& reference, double pixels_per_degree, const ExposureRange& exposures);

/// The tone curve: (0.9036 x² + 0.018 x)/(0.8748 x² + 0.354 x + 0.14), clamped to [0, 1].
double aces_tone_curve(double x);

}  // namespace sturm
