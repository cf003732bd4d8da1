#include "wavefront/layers/layer_detail.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace sturm {

namespace {

/// Of a difference between neighbours, by the larger one of those beside it: 0 for a step between two plateaus, 1 where
/// it belongs to a slope of several pixels.
float share_of(float difference, float beside) {
  constexpr float none_up_to = 0.2f, all_from = 0.45f;  // of the difference
  const float ratio = beside / std::abs(difference);
  return std::clamp((ratio - none_up_to) / (all_from - none_up_to), 0.0f, 1.0f);
}

}  // namespace

const float* LayerDetail::neighbour(int x, int y, int dx, int dy) const {
  const int u = x + dx, v = y + dy;
  if (u < 0 || v < 0 || u >= radiance_.width || v >= radiance_.height) return nullptr;
  const std::size_t here = static_cast<std::size_t>(y) * radiance_.width + x,
                    there = static_cast<std::size_t>(v) * radiance_.width + u;
  const bool covers = coverage_.empty() || coverage_[there] > 0.0f;
  return covers && std::abs(vergence_D_[there] - vergence_D_[here]) <= jump_D_ ? radiance_.at(u, v) : nullptr;
}

Detail LayerDetail::at(int x, int y) const {
  constexpr float twelfth = 1.0f / 12.0f, most = 0.25f;
  constexpr int steps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  const float* const own = radiance_.at(x, y);
  Detail detail{};
  for (const auto& [dx, dy] : steps) {
    const float* const other = neighbour(x, y, dx, dy);
    if (!other) continue;
    const float *const before = neighbour(x, y, -dx, -dy), *const beyond = neighbour(x + dx, y + dy, dx, dy);
    for (int c = 0; c < 3; ++c) {
      const float difference = own[c] - other[c], limit = most * std::min(own[c], other[c]);
      if (difference == 0.0f) continue;
      const float beside =
          std::max(before ? std::abs(own[c] - before[c]) : 0.0f, beyond ? std::abs(other[c] - beyond[c]) : 0.0f);
      detail[c] += std::clamp(twelfth * share_of(difference, beside) * difference, -limit, limit);
    }
  }
  return detail;
}

std::vector<Detail> detail_of(const LayeredPicture& picture) {
  const int width = picture.radiance.width;
  const LayerDetail layer(picture.radiance, picture.vergence_D, picture.coverage, picture.jump_D);
  std::vector<Detail> detail(picture.vergence_D.size());
  tbb::parallel_for(0, picture.radiance.height, [&](int y) {
    for (int x = 0; x < width; ++x) detail[static_cast<std::size_t>(y) * width + x] = layer.at(x, y);
  });
  return detail;
}

}  // namespace sturm
