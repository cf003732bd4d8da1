#include "compare/metrics/relative_mse.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "compare/metrics/pixel_errors.h"

namespace sturm {

namespace {

constexpr double trimmed_share = 0.001;

double mean(const std::vector<double>& values, std::size_t first) {
  if (first >= values.size()) return 0.0;
  return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(first), values.end(), 0.0) /
         static_cast<double>(values.size() - first);
}

}  // namespace

double trimmed_mean(std::vector<double> values) {
  std::sort(values.begin(), values.end(), std::greater<>());
  return mean(values, static_cast<std::size_t>(trimmed_share * static_cast<double>(values.size())));
}

RelativeMse relative_mse(const Image& test, const Image& reference) {
  const std::vector<double> errors = relative_squared_errors(test, reference);
  return {mean(errors, 0), trimmed_mean(errors)};
}

}  // namespace sturm
