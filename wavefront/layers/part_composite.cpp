#include "wavefront/layers/part_composite.h"

#include <algorithm>

namespace sturm {

namespace {

constexpr float coverage_rounding = 1e-6f;  // of a coverage: transforms in single precision are ten times better

}  // namespace

bool lay_behind(const TileLight& layer, const CellBox& cells, TileLight& total) {
  const int coverages = layer.coverages();
  float least = 1.0f;
  for (int y = cells.top; y < cells.bottom; ++y)
    for (int k = 0; k < coverages; ++k) {
      const float* const alpha = layer.planes[3 + k].at(0, y);
      float* const covered = total.planes[3 + k].at(0, y);
      for (int c = k; c < (coverages == 1 ? 3 : k + 1); ++c) {
        const float* const light = layer.planes[c].at(0, y);
        float* const sum = total.planes[c].at(0, y);
        for (int x = cells.left; x < cells.right; ++x) {
          const float room = std::max(0.0f, 1.0f - covered[x]);
          sum[x] += (alpha[x] > room ? room / alpha[x] : alpha[x] > 0.0f ? 1.0f : room) * light[x];
        }
      }
      for (int x = cells.left; x < cells.right; ++x) {
        covered[x] = std::min(1.0f, covered[x] + alpha[x]);
        least = std::min(least, covered[x]);
      }
    }
  return least >= 1.0f - coverage_rounding;
}

void clear_rounding(const CellBox& cells, TileLight& layer) {
  const int coverages = layer.coverages();
  for (int y = cells.top; y < cells.bottom; ++y) {
    for (int c = 0; c < 3; ++c) {
      const float* const alpha = layer.planes[3 + (coverages == 1 ? 0 : c)].at(0, y);
      float* const light = layer.planes[c].at(0, y);
      for (int x = cells.left; x < cells.right; ++x)
        light[x] = alpha[x] < coverage_rounding ? 0.0f : std::max(0.0f, light[x]);
    }
    for (int k = 0; k < coverages; ++k) {
      float* const alpha = layer.planes[3 + k].at(0, y);
      for (int x = cells.left; x < cells.right; ++x) alpha[x] = alpha[x] < coverage_rounding ? 0.0f : alpha[x];
    }
  }
}

}  // namespace sturm
