#include "wavefront/layers/detail_share.h"

#include <algorithm>
#include <vector>

namespace sturm {

namespace {

// Sums of the squared differences of neighbouring weights: those of discs whose radii are 7 and 5 px.
constexpr double even = 1e-3, steep = 3e-3;

/// The kernel of the whole pupil, with a rim of one empty pixel.
class WholeKernel {
 public:
  explicit WholeKernel(std::span<const WeightedKernel> parts) {
    int radius = 0;
    for (const WeightedKernel& part : parts) radius = std::max(radius, part.kernel->radius_px);
    side_ = 2 * radius + 3;
    weights_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), 0.0);
    for (const auto& [kernel, weight] : parts)
      for (int y = -kernel->radius_px; y <= kernel->radius_px; ++y)
        for (int x = -kernel->radius_px; x <= kernel->radius_px; ++x)
          weights_[index(x + radius + 1, y + radius + 1)] += weight * kernel->weight(x, y);
  }

  double steepness() const {
    double sum = 0.0;
    const auto add = [&](double difference) { sum += difference * difference; };
    for (int y = 0; y + 1 < side_; ++y)
      for (int x = 0; x + 1 < side_; ++x) {
        add(weights_[index(x + 1, y)] - weights_[index(x, y)]);
        add(weights_[index(x, y + 1)] - weights_[index(x, y)]);
      }
    return sum;
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(x);
  }

  int side_;
  std::vector<double> weights_;
};

}  // namespace

float detail_share_of(std::span<const WeightedKernel> parts) {
  double widening_px2 = 0.0;
  for (const auto& [kernel, weight] : parts) widening_px2 += weight * kernel->widening_px2;
  if (!(widening_px2 > 0.0)) return 0.0f;
  const double left = std::clamp((WholeKernel(parts).steepness() - even) / (steep - even), 0.0, 1.0);
  return static_cast<float>(std::min(1.0, 6.0 * widening_px2) * left);
}

}  // namespace sturm
