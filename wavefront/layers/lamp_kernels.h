#pragma once
#include <span>
#include <vector>

#include "wavefront/layers/kernel_bank.h"
#include "wavefront/layers/layered_picture.h"

namespace sturm {

/// The middle of one of the 4 × 4 places of a pixel (`LampPixel::places`), from the pixel's own [px, to the right and
/// down].
inline Eigen::Vector2d middle_of_place(int place) {
  return {(place % 4 - 1.5) / 4.0, (place / 4 - 1.5) / 4.0};
}

/// The kernels of lamps: of light that lies in some of the 4 × 4 places of its pixel, for the planes on which the lamps
/// of a picture are. Immutable.
class LampKernels {
 public:
  LampKernels(const KernelBank& bank, std::span<const LampPixel> lamps);

  /// Whether light in these places of a pixel has kernels of its own on the plane; else it counts as all over its
  /// pixel.
  bool parted(int plane, std::uint16_t places) const {
    return places != all_places && !kernels_.empty() && !kernels_[static_cast<std::size_t>(plane)].empty();
  }

  /// Of light in one place, on a plane where it is parted.
  const SpreadKernel& kernel(int plane, int part, int channel, int place) const {
    return kernels_[static_cast<std::size_t>(plane)]
                   [(static_cast<std::size_t>(part) * channels_ + static_cast<std::size_t>(channel)) * 16 + place];
  }

 private:
  std::size_t channels_;
  std::vector<std::vector<SpreadKernel>> kernels_;  // of each plane; empty where no lamp is
};

}  // namespace sturm
