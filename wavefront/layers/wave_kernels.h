#pragma once
#include "lensmodel/eye.h"
#include "wavefront/layers/kernel_model.h"

namespace sturm {

/// The kernels of an eye by diffraction, of the pupil as a whole: light that interferes cannot be told apart by the
/// part of the pupil that it went through. Without colour the light is that of `luminance_weighted_light`; with it, R,
/// G and B are seen at `primary_wavelengths_nm`. `pixel_slope`: size of a pixel in tangent units. Throws
/// std::invalid_argument for a pinhole, and from `kernel` where a wave would need too fine a grid, or a kernel exceeds
/// `largest_kernel_radius_px`.
KernelModel wave_kernels(const Eye& eye, double accommodation_D, double pixel_slope, bool chromatic);

}  // namespace sturm
