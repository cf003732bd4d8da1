#include "compare/metrics/relative_mse.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

#include "compare/metrics/comparable.h"

namespace sturm {

namespace {
constexpr double offset = 0.01;  // keeps black pixels from dividing by zero; the value that the literature uses
constexpr double trimmed_share = 0.001;
}  // namespace

RelativeMse relative_mse(const Image& test, const Image& reference) {
  require_comparable(test, reference);
  const int channels = test.channels;
  std::vector<double> errors(test.pixels.size() / channels);
  for (std::size_t pixel = 0; pixel < errors.size(); ++pixel) {
    for (int c = 0; c < channels; ++c) {
      const double r = reference.pixels[pixel * channels + c], difference = test.pixels[pixel * channels + c] - r;
      errors[pixel] += difference * difference / (r * r + offset);
    }
    errors[pixel] /= channels;
  }
  const auto mean = [](auto first, auto last) { return std::accumulate(first, last, 0.0) / static_cast<double>(last - first); };
  RelativeMse result;
  result.plain = mean(errors.begin(), errors.end());
  std::sort(errors.begin(), errors.end(), std::greater<>());
  result.trimmed = mean(errors.begin() + static_cast<std::ptrdiff_t>(trimmed_share * static_cast<double>(errors.size())), errors.end());
  return result;
}

}  // namespace sturm
