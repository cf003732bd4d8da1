#include "wavefront/psf/spread_kernel.h"

#include <numeric>

namespace sturm {

double SpreadKernel::sum() const {
  return std::accumulate(weights.begin(), weights.end(), 0.0);
}

}  // namespace sturm
