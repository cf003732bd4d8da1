#include "compare/metrics/relative_mse.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "compare/metrics/pixel_errors.h"

namespace sturm {

RelativeMse trimmed_mean(std::vector<double> errors) {
  constexpr double trimmed_share = 0.001;
  const auto mean = [](auto first, auto last) { return std::accumulate(first, last, 0.0) / static_cast<double>(last - first); };
  RelativeMse result;
  result.plain = mean(errors.begin(), errors.end());
  std::sort(errors.begin(), errors.end(), std::greater<>());
  result.trimmed = mean(errors.begin() + static_cast<std::ptrdiff_t>(trimmed_share * static_cast<double>(errors.size())), errors.end());
  return result;
}

RelativeMse relative_mse(const Image& test, const Image& reference) {
  return trimmed_mean(relative_squared_errors(test, reference));
}

}  // namespace sturm
