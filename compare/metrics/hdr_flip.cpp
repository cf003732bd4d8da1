#include "compare/metrics/hdr_flip.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/metrics/comparable.h"
#include "compare/metrics/luma.h"

namespace sturm {

namespace {

// x ↦ (n2 x² + n1 x)/(d2 x² + d1 x + d0)
constexpr double n2 = 0.6 * 0.6 * 2.51, n1 = 0.6 * 0.03, d2 = 0.6 * 0.6 * 2.43, d1 = 0.6 * 0.59, d0 = 0.14;
constexpr double target_brightness = 0.85;
constexpr int most_exposures = 16;

/// x > 0 with the tone curve at `y`: the larger root of (n2 − y d2) x² + (n1 − y d1) x − y d0 = 0.
double inverse_tone_curve(double y) {
  const double half = 0.5 * (n1 - y * d1) / (n2 - y * d2), constant = -y * d0 / (n2 - y * d2);
  return -half + std::sqrt(half * half - constant);
}

Image tone_mapped(const Image& light, double stops) {
  Image result = light;
  const double factor = std::exp2(stops);
  for (float& v : result.pixels) v = static_cast<float>(aces_tone_curve(factor * std::max(0.0f, v)));
  return result;
}

}  // namespace

double aces_tone_curve(double x) {
  return std::clamp((n2 * x * x + n1 * x) / (d2 * x * x + d1 * x + d0), 0.0, 1.0);
}

ExposureRange hdr_flip_exposures(const Image& reference) {
  require_finite(reference, "reference image");
  std::vector<double> luminances = luma(reference);
  std::erase_if(luminances, [](double y) { return y <= 0.0; });
  if (luminances.empty()) return {};
  const double x = inverse_tone_curve(target_brightness);
  const double brightest = *std::max_element(luminances.begin(), luminances.end());
  const std::size_t n = luminances.size();
  const auto at = [&](std::size_t rank) {
    std::nth_element(luminances.begin(), luminances.begin() + static_cast<std::ptrdiff_t>(rank), luminances.end());
    return luminances[rank];
  };
  const double median = 0.5 * (at((n - 1) / 2) + at(n / 2));
  ExposureRange range{std::log2(x / brightest), std::log2(x / median), 1};
  range.count = std::clamp(static_cast<int>(std::ceil(range.stop_stops - range.start_stops)), 2, most_exposures);
  return range;
}

Flip hdr_flip(const Image& test, const Image& reference, double pixels_per_degree, const ExposureRange& exposures) {
  Flip result;
  for (int i = 0; i < exposures.count; ++i) {
    const double stops = exposures.stops(i);
    const Flip one = flip_of_light(tone_mapped(test, stops), tone_mapped(reference, stops), pixels_per_degree);
    if (i == 0) {
      result = one;
      continue;
    }
    for (std::size_t p = 0; p < result.map.pixels.size(); ++p)
      result.map.pixels[p] = std::max(result.map.pixels[p], one.map.pixels[p]);
  }
  double sum = 0.0;
  for (const float v : result.map.pixels) sum += v;
  result.mean = sum / static_cast<double>(result.map.pixels.size());
  return result;
}

}  // namespace sturm
