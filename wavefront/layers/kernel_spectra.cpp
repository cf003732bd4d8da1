#include "wavefront/layers/kernel_spectra.h"

#include <tbb/parallel_for.h>

#include "wavefront/fft/tile_transform.h"

namespace sturm {

namespace {

/// With its middle in the first cell and what lies left of or above it at the far end.
Image wrapped(const SpreadKernel& kernel, int side) {
  Image tile(side, side, 1);
  for (int dy = -kernel.radius_px; dy <= kernel.radius_px; ++dy)
    for (int dx = -kernel.radius_px; dx <= kernel.radius_px; ++dx)
      *tile.at((dx + side) % side, (dy + side) % side) = kernel.weight(dx, dy);
  return tile;
}

}  // namespace

KernelSpectra::KernelSpectra(const KernelBank& bank, const BlurPlan& plan)
    : parts_(bank.parts().size()),
      channels_(static_cast<std::size_t>(bank.channels())),
      spectra_(bank.planes_D().size() * parts_ * channels_) {
  tbb::parallel_for(std::size_t{0}, spectra_.size(), [&](std::size_t i) {
    const auto plane = static_cast<int>(i / channels_ / parts_);
    if (!plan.transforms(plane)) return;
    const Image tile = wrapped(
        bank.kernel(plane, static_cast<int>(i / channels_ % parts_), static_cast<int>(i % channels_)), plan.side());
    spectra_[i] = Image(plan.side(), plan.side(), 1);
    transform_tile(tile, spectra_[i]);
  });
}

}  // namespace sturm
