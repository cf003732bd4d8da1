#include "experiments/standard/noise_floor_error.h"

#include <cmath>

#include "compare/statistics/jackknife.h"

namespace sturm {

std::optional<double> noise_floor_error(const Replicates& replicates,
                                        const std::function<double(const Image&, const Image&)>& measure) {
  const int count = static_cast<int>(replicates.images.size()), half = count / 2;
  if (half < 2) return std::nullopt;
  const Image first = replicates.first_half(), second = replicates.second_half();
  std::vector<double> without_one_of_first, without_one_of_second;
  for (int r = 0; r < half; ++r) without_one_of_first.push_back(measure(replicates.first_half(r), second));
  for (int r = half; r < count; ++r) without_one_of_second.push_back(measure(first, replicates.second_half(r)));
  return std::hypot(jackknife_standard_error(without_one_of_first), jackknife_standard_error(without_one_of_second));
}

}  // namespace sturm
