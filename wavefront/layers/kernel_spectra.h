#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "wavefront/layers/blur_plan.h"
#include "wavefront/layers/kernel_bank.h"

namespace sturm {

/// The spectra of the kernels that the plan may ask for. As many as fit in `most_bytes` are kept, those of the first
/// planes; the others are made where they are asked for. Immutable.
class KernelSpectra {
 public:
  static constexpr std::size_t most_bytes_kept = std::size_t{1} << 28;

  KernelSpectra(const KernelBank& bank, const BlurPlan& plan, std::size_t most_bytes = most_bytes_kept);

  /// Spectra that are not kept, the last one of each channel. Each thread has its own.
  struct Scratch {
    std::array<std::size_t, 3> index = {none, none, none};
    std::array<Image, 3> spectra;
    Image tile;

    static constexpr std::size_t none = static_cast<std::size_t>(-1);
  };

  const Image& of(int plane, int part, int channel, Scratch& scratch) const;

 private:
  void transform(std::size_t index, Image& tile, Image& spectrum) const;

  const KernelBank& bank_;
  int side_;
  std::size_t parts_, channels_;
  std::vector<Image> spectra_;  // empty: not kept, or not asked for
};

}  // namespace sturm
