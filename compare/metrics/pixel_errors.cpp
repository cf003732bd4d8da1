#include "compare/metrics/pixel_errors.h"

#include <cmath>
#include <numeric>

#include "compare/metrics/comparable.h"

namespace sturm {

namespace {

// Keeps black pixels from dividing by zero; the value that the literature uses.
constexpr double offset = 0.01;

template <class Error>
std::vector<double> per_pixel(const Image& test, const Image& reference, const Error& error) {
  require_comparable(test, reference);
  const int channels = test.channels;
  std::vector<double> errors(test.pixels.size() / channels);
  for (std::size_t pixel = 0; pixel < errors.size(); ++pixel) {
    for (int c = 0; c < channels; ++c) {
      const double x = test.pixels[pixel * channels + c], r = reference.pixels[pixel * channels + c];
      errors[pixel] += error(x, r);
    }
    errors[pixel] /= channels;
  }
  return errors;
}

}  // namespace

double relative_square(double squared_difference, double reference) {
  return squared_difference / (reference * reference + offset);
}

std::vector<double> squared_errors(const Image& test, const Image& reference) {
  return per_pixel(test, reference, [](double x, double r) { return (x - r) * (x - r); });
}

std::vector<double> relative_squared_errors(const Image& test, const Image& reference) {
  return per_pixel(test, reference, [](double x, double r) { return relative_square((x - r) * (x - r), r); });
}

std::vector<double> symmetric_relative_errors(const Image& test, const Image& reference) {
  return per_pixel(test, reference,
                   [](double x, double r) { return std::abs(x - r) / (std::abs(x) + std::abs(r) + offset); });
}

double smape(const Image& test, const Image& reference) {
  const std::vector<double> errors = symmetric_relative_errors(test, reference);
  return std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
}

Image error_map(const std::vector<double>& errors, int width, int height) {
  Image map(width, height, 1);
  for (std::size_t i = 0; i < errors.size(); ++i) map.pixels[i] = static_cast<float>(errors[i]);
  return map;
}

}  // namespace sturm
