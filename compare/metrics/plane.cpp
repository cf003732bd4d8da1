#include "compare/metrics/plane.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace sturm {

Plane filtered_along_x(const Plane& plane, std::span<const float> along_x) {
  const int radius = static_cast<int>(along_x.size()) / 2;
  Plane result(plane.width, plane.height);
  tbb::parallel_for(0, plane.height, [&](int y) {
    const float* row = &plane.values[static_cast<std::size_t>(y) * plane.width];
    std::vector<float> padded(static_cast<std::size_t>(plane.width) + 2 * radius);
    std::fill_n(padded.begin(), radius, row[0]);
    std::copy_n(row, plane.width, padded.begin() + radius);
    std::fill_n(padded.end() - radius, radius, row[plane.width - 1]);
    float* out = &result.values[static_cast<std::size_t>(y) * plane.width];
    for (std::size_t t = 0; t < along_x.size(); ++t)
      for (int x = 0; x < plane.width; ++x) out[x] += along_x[t] * padded[x + t];
  });
  return result;
}

Plane filtered_along_y(const Plane& plane, std::span<const float> along_y) {
  const int radius = static_cast<int>(along_y.size()) / 2;
  Plane result(plane.width, plane.height);
  tbb::parallel_for(0, plane.height, [&](int y) {
    float* out = &result.values[static_cast<std::size_t>(y) * plane.width];
    for (std::size_t t = 0; t < along_y.size(); ++t) {
      const int source = std::clamp(y + static_cast<int>(t) - radius, 0, plane.height - 1);
      const float* row = &plane.values[static_cast<std::size_t>(source) * plane.width];
      for (int x = 0; x < plane.width; ++x) out[x] += along_y[t] * row[x];
    }
  });
  return result;
}

}  // namespace sturm
