#pragma once
#include "wavefront/psf/ray_fan.h"

namespace sturm {

/// Point spreads on the pixels of a picture. A pixel is `pixel_rad` wide, in slopes from the picture's middle; rows go
/// from the top down.

/// By rays: wide enough for all of them; the weights are their shares.
SpreadKernel ray_kernel(const RayFan& fan, double vergence_D, double pixel_rad);

/// By waves: wide enough for all but `left_out` of the energy within the window. The weights are the exact integrals
/// over the pixels, scaled to sum to 1.
SpreadKernel wave_kernel(const WavePsf& psf, double pixel_rad, double left_out = 2e-3);

/// Those of one wave at many vergence errors [D], side by side on coarser grids (512² where the slopes allow it), which
/// pixels much larger than the diffraction limit do not see. Throws AliasedSampling.
std::vector<SpreadKernel> wave_kernels(const PupilWave& pupil, const Light& light,
                                       const std::vector<double>& vergences_D, double pixel_rad);

}  // namespace sturm
