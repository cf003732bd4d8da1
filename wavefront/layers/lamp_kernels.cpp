#include "wavefront/layers/lamp_kernels.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace sturm {

namespace {

std::vector<char> planes_of(const KernelBank& bank, std::span<const LampPixel> lamps) {
  std::vector<char> used(bank.planes_D().size(), 0);
  for (const LampPixel& lamp : lamps) {
    if (lamp.places == all_places) continue;
    const auto [plane, next_weight] = bank.place_of(lamp.vergence_D);
    used[static_cast<std::size_t>(plane)] = 1;
    if (next_weight > 0.0f) used[static_cast<std::size_t>(plane) + 1] = 1;
  }
  return used;
}

}  // namespace

LampKernels::LampKernels(const KernelBank& bank, std::span<const LampPixel> lamps)
    : channels_(static_cast<std::size_t>(bank.channels())) {
  if (!bank.point_kernel()) return;
  const std::vector<char> used = planes_of(bank, lamps);
  if (std::find(used.begin(), used.end(), 1) == used.end()) return;
  kernels_.resize(used.size());
  for (std::size_t plane = 0; plane < used.size(); ++plane) {
    if (!used[plane]) continue;
    kernels_[plane].resize(bank.parts().size() * channels_ * 16);
    tbb::parallel_for(std::size_t{0}, kernels_[plane].size(), [&](std::size_t i) {
      kernels_[plane][i] =
          bank.point_kernel()(bank.planes_D()[plane], static_cast<int>(i / 16 / channels_),
                              static_cast<int>(i / 16 % channels_), middle_of_place(static_cast<int>(i % 16)));
    });
  }
}

}  // namespace sturm
