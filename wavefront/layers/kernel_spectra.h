#pragma once
#include <vector>

#include "wavefront/layers/blur_plan.h"
#include "wavefront/layers/kernel_bank.h"

namespace sturm {

/// The spectra of the kernels that the plan may ask for. Immutable.
class KernelSpectra {
 public:
  KernelSpectra(const KernelBank& bank, const BlurPlan& plan);

  const Image& of(int plane, int part, int channel) const {
    return spectra_[(static_cast<std::size_t>(plane) * parts_ + part) * channels_ + channel];
  }

 private:
  std::size_t parts_, channels_;
  std::vector<Image> spectra_;
};

}  // namespace sturm
