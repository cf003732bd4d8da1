#include "compare/studies/bench/reference_image.h"

#include <algorithm>

#include "compare/metrics/comparable.h"
#include "compare/metrics/pixel_errors.h"
#include "compare/metrics/relative_mse.h"
#include "compare/metrics/ssim.h"
#include "io/images/tone_map.h"

namespace sturm {

namespace {

constexpr int channels = 3;

Image mean_of(const Image& a, const Image& b) {
  require_comparable(a, b);
  Image mean(a.width, a.height, a.channels);
  for (std::size_t i = 0; i < mean.pixels.size(); ++i)
    mean.pixels[i] = static_cast<float>(0.5 * (static_cast<double>(a.pixels[i]) + b.pixels[i]));
  return mean;
}

double neighbourhood_mean(const Image& image, int x, int y) {
  double sum = 0.0, count = 0.0;
  for (int v = std::max(0, y - 1); v <= std::min(image.height - 1, y + 1); ++v)
    for (int u = std::max(0, x - 1); u <= std::min(image.width - 1, x + 1); ++u)
      for (int c = 0; c < image.channels; ++c) sum += image.at(u, v)[c], ++count;
  return sum / count;
}

std::vector<double> squared_differences(const Image& a, const Image& b, double factor) {
  std::vector<double> squares(a.pixels.size());
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const double difference = static_cast<double>(a.pixels[i]) - b.pixels[i];
    squares[i] = factor * difference * difference;
  }
  return squares;
}

}  // namespace

ReferenceImage::ReferenceImage(const Image& first_half, const Image& second_half,
                               std::optional<double> max_neighbourhood_radiance, double exposure)
    : mean_(mean_of(first_half, second_half)),
      display_(to_display(mean_, exposure)),
      exposure_(exposure),
      counts_(static_cast<std::size_t>(mean_.width) * mean_.height, true) {
  if (max_neighbourhood_radiance)
    for (int y = 0; y < mean_.height; ++y)
      for (int x = 0; x < mean_.width; ++x)
        if (neighbourhood_mean(mean_, x, y) > *max_neighbourhood_radiance) {
          counts_[static_cast<std::size_t>(y) * mean_.width + x] = false;
          ++pixels_left_out_;
        }
  floor_ = from_squares(squared_differences(first_half, second_half, 0.25));
  floor_.one_minus_ssim = 1.0 - ssim(to_display(first_half, exposure), to_display(second_half, exposure)).mean;
}

PictureErrors ReferenceImage::from_squares(const std::vector<double>& squares) const {
  PictureErrors errors;
  for (const double square : squares) errors.mse += square;
  errors.mse /= static_cast<double>(squares.size());
  std::vector<double> counted;
  counted.reserve(counts_.size());
  for (std::size_t pixel = 0; pixel < counts_.size(); ++pixel) {
    double relative = 0.0;
    for (std::size_t i = channels * pixel; i < channels * (pixel + 1); ++i)
      relative += relative_square(squares[i], mean_.pixels[i]) / channels;
    errors.relative_mse += relative;
    if (counts_[pixel]) counted.push_back(relative);
  }
  errors.relative_mse /= static_cast<double>(counts_.size());
  errors.relative_mse_trimmed = trimmed_mean(std::move(counted));
  return errors;
}

PictureErrors ReferenceImage::errors_of(const Image& test) const {
  require_comparable(test, mean_);
  PictureErrors errors = from_squares(squared_differences(test, mean_, 1.0));
  errors.one_minus_ssim = 1.0 - ssim(to_display(test, exposure_), display_).mean;
  return errors;
}

}  // namespace sturm
