#pragma once
#include <span>

#include "wavefront/psf/spread_kernel.h"

namespace sturm {

/// A kernel of one part of the pupil, with the part's share of the light.
struct WeightedKernel {
  const SpreadKernel* kernel;
  double weight;
};

/// How much of a surface's detail (layer_detail.h) belongs to a blur, 0 … 1: all of it for kernels that sharing light
/// out among pixels has widened by 1/6 px² along each axis. None where the whole pupil's kernel has no steep flank, as
/// that of a disc whose radius is 7 px or more: it leaves less than 4·10⁻⁴ of the light to detail, and what surrounds a
/// pixel would be lit from one pixel farther away than the kernel reaches.
float detail_share_of(std::span<const WeightedKernel> parts);

}  // namespace sturm
