#include "compare/metrics/relative_mse.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

#include "compare/metrics/comparable.h"

namespace sturm {

namespace {
constexpr double offset = 0.01;
constexpr double trimmed_share = 0.001;

double mean(const std::vector<double>& values, std::size_t first) {
  if (first >= values.size()) return 0.0;
  return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(first), values.end(), 0.0) /
         static_cast<double>(values.size() - first);
}

}  // namespace

double relative_square(double squared_difference, double reference) {
  return squared_difference / (reference * reference + offset);
}

double trimmed_mean(std::vector<double> values) {
  std::sort(values.begin(), values.end(), std::greater<>());
  return mean(values, static_cast<std::size_t>(trimmed_share * static_cast<double>(values.size())));
}

RelativeMse relative_mse(const Image& test, const Image& reference) {
  require_comparable(test, reference);
  const int channels = test.channels;
  std::vector<double> errors(test.pixels.size() / channels);
  for (std::size_t pixel = 0; pixel < errors.size(); ++pixel) {
    for (int c = 0; c < channels; ++c) {
      const double r = reference.pixels[pixel * channels + c], difference = test.pixels[pixel * channels + c] - r;
      errors[pixel] += relative_square(difference * difference, r);
    }
    errors[pixel] /= channels;
  }
  RelativeMse result;
  result.plain = mean(errors, 0);
  result.trimmed = trimmed_mean(std::move(errors));
  return result;
}

}  // namespace sturm
