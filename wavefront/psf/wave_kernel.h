#pragma once
#include "wavefront/psf/spread_kernel.h"
#include "wavefront/psf/wave_measures.h"

namespace sturm {

/// A wave's point spread on the pixels of a picture, `pixel_rad` wide in slopes from the picture's middle; rows go from
/// the top down. It is wide enough for all but `left_out` of the energy within the window. The weights are the exact
/// integrals over the pixels, scaled to sum to 1. Throws std::invalid_argument where it would have a larger radius.
SpreadKernel wave_kernel(const WavePsf& psf, double pixel_rad, int largest_radius_px, double left_out = 2e-3);

}  // namespace sturm
