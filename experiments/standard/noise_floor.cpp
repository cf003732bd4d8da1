#include "experiments/standard/noise_floor.h"

#include <cmath>

#include "compare/statistics/jackknife.h"

namespace sturm {

PictureNoiseFloor noise_floor(const Replicates& replicates, std::span<const FloorMetric> metrics) {
  const int count = static_cast<int>(replicates.images.size()), half = count / 2;
  const Image first = replicates.first_half(), second = replicates.second_half();
  PictureNoiseFloor floor;
  for (const FloorMetric& metric : metrics) {
    floor.metrics[metric.name] = metric.of(first, second);
    if (half < 2) continue;
    std::vector<double> without_one_of_first, without_one_of_second;
    for (int r = 0; r < half; ++r) without_one_of_first.push_back(metric.of(replicates.first_half(r), second));
    for (int r = half; r < count; ++r) without_one_of_second.push_back(metric.of(first, replicates.second_half(r)));
    floor.uncertainties[metric.name] =
        std::hypot(jackknife_standard_error(without_one_of_first), jackknife_standard_error(without_one_of_second));
  }
  return floor;
}

}  // namespace sturm
