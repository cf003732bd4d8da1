#include "wavefront/layers/blur_plan.h"

#include <algorithm>
#include <cmath>

namespace sturm {

namespace {

// Of one core; only their ratio matters.
constexpr double seconds_per_tap = 0.1e-9;              // of one cell
constexpr double seconds_per_cell_and_octave = 0.6e-9;  // of one transform: 0.3 ms for 256 x 256
constexpr int smallest_side = 256;

}  // namespace

BlurPlan::BlurPlan(const KernelBank& bank)
    : side_(smallest_side), rim_(bank.largest_radius_px()), parts_(static_cast<int>(bank.parts().size())) {
  while (4 * rim_ > side_) side_ *= 2;
  for (int plane = 0; plane < static_cast<int>(bank.planes_D().size()); ++plane) {
    radius_.push_back(bank.radius_px(plane));
    double most = 0.0;
    for (int channel = 0; channel < bank.channels(); ++channel) {
      double taps = 0.0;
      for (int part = 0; part < parts_; ++part) {
        const std::vector<float>& weights = bank.kernel(plane, part, channel).weights;
        taps += static_cast<double>(weights.size() - std::count(weights.begin(), weights.end(), 0.0f));
      }
      most = std::max(most, taps);
    }
    taps_.push_back(most);
  }
}

BlurMethod BlurPlan::method(int plane, const CellBox& lit, int planes, bool same_light) const {
  const int radius = radius_[plane];
  if (radius == 0) return BlurMethod::Unblurred;
  const double cells = static_cast<double>(side_) * side_;
  const double reached = static_cast<double>(lit.grown(radius).within(kept()).area());
  const double spatial = seconds_per_tap * reached * taps_[plane] * planes;
  const double transform =
      seconds_per_cell_and_octave * cells * std::log2(side_) * planes * ((same_light ? 1.0 : parts_) + parts_);
  return spatial < transform ? BlurMethod::Spatial : BlurMethod::Transform;
}

}  // namespace sturm
