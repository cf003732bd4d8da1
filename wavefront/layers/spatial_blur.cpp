#include "wavefront/layers/spatial_blur.h"

#include <algorithm>

namespace sturm {

CellBox CellBox::within(const CellBox& o) const {
  return {std::max(left, o.left), std::max(top, o.top), std::min(right, o.right), std::min(bottom, o.bottom)};
}

void add_blurred(const Image& light, const CellBox& from, const SpreadKernel& kernel, const CellBox& into,
                 Image& blurred) {
  const CellBox reached = from.grown(kernel.radius_px).within(into);
  for (int y = reached.top; y < reached.bottom; ++y) {
    float* const out = blurred.at(0, y);
    const int first = std::max(-kernel.radius_px, y - from.bottom + 1), last = std::min(kernel.radius_px, y - from.top);
    for (int dy = first; dy <= last; ++dy) {
      const float* const in = light.at(0, y - dy);
      for (int dx = -kernel.radius_px; dx <= kernel.radius_px; ++dx) {
        const float weight = kernel.weight(dx, dy);
        if (weight == 0.0f) continue;
        const int begin = std::max(reached.left, from.left + dx), end = std::min(reached.right, from.right + dx);
        for (int x = begin; x < end; ++x) out[x] += weight * in[x - dx];
      }
    }
  }
}

}  // namespace sturm
