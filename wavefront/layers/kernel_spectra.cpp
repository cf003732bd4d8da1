#include "wavefront/layers/kernel_spectra.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "wavefront/fft/tile_transform.h"

namespace sturm {

namespace {

/// With its middle in the first cell and what lies left of or above it at the far end.
void wrap(const SpreadKernel& kernel, Image& tile) {
  std::fill(tile.pixels.begin(), tile.pixels.end(), 0.0f);
  const int side = tile.width;
  for (int dy = -kernel.radius_px; dy <= kernel.radius_px; ++dy)
    for (int dx = -kernel.radius_px; dx <= kernel.radius_px; ++dx)
      *tile.at((dx + side) % side, (dy + side) % side) = kernel.weight(dx, dy);
}

Image empty_tile(int side) {
  return {side, side, 1};
}

}  // namespace

KernelSpectra::KernelSpectra(const KernelBank& bank, const BlurPlan& plan, std::size_t most_bytes)
    : bank_(bank),
      side_(plan.side()),
      parts_(bank.parts().size()),
      channels_(static_cast<std::size_t>(bank.channels())),
      spectra_(bank.planes_D().size() * parts_ * channels_) {
  const std::size_t bytes = static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) * sizeof(float);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < spectra_.size() && (kept.size() + 1) * bytes <= most_bytes; ++i)
    if (plan.transforms(static_cast<int>(i / channels_ / parts_))) kept.push_back(i);
  tbb::parallel_for(std::size_t{0}, kept.size(), [&](std::size_t k) {
    Image tile = empty_tile(side_);
    spectra_[kept[k]] = empty_tile(side_);
    transform(kept[k], tile, spectra_[kept[k]]);
  });
}

const Image& KernelSpectra::of(int plane, int part, int channel, Scratch& scratch) const {
  const auto c = static_cast<std::size_t>(channel);
  const std::size_t index = (static_cast<std::size_t>(plane) * parts_ + static_cast<std::size_t>(part)) * channels_ + c;
  if (!spectra_[index].pixels.empty()) return spectra_[index];
  if (scratch.index[c] != index) {
    if (scratch.tile.pixels.empty()) scratch.tile = empty_tile(side_);
    if (scratch.spectra[c].pixels.empty()) scratch.spectra[c] = empty_tile(side_);
    transform(index, scratch.tile, scratch.spectra[c]);
    scratch.index[c] = index;
  }
  return scratch.spectra[c];
}

void KernelSpectra::transform(std::size_t index, Image& tile, Image& spectrum) const {
  wrap(bank_.kernel(static_cast<int>(index / channels_ / parts_), static_cast<int>(index / channels_ % parts_),
                    static_cast<int>(index % channels_)),
       tile);
  transform_tile(tile, spectrum);
}

}  // namespace sturm
