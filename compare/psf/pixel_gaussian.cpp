#include "compare/psf/pixel_gaussian.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sturm {

namespace {

constexpr double least_deviation = 0.05;
constexpr double well_sampled = 2.0;  // from here on pixels have the variance σ² + 1/12 to exp(−2π²·4)

double normal_density(double x) {
  return std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi);
}

double normal_share(double x) {
  return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

/// Integral of the normal distribution's share up to x.
double integrated_share(double x) {
  return x * normal_share(x) + normal_density(x);
}

}  // namespace

PixelGaussian::PixelGaussian(const Eigen::VectorXd& light) {
  const Eigen::ArrayXd places = Eigen::ArrayXd::LinSpaced(light.size(), 0.0, static_cast<double>(light.size() - 1));
  const double mean = (light.array() * places).sum(), variance = (light.array() * (places - mean).square()).sum();
  middle_ = mean;
  deviation_ = std::sqrt(std::max(variance - 1.0 / 12.0, least_deviation * least_deviation));
  if (deviation_ < well_sampled) match(mean, variance);
}

/// Half of each difference is taken: a Gaussian in the middle of its pixel answers with up to 1.85 times the step.
void PixelGaussian::match(double mean, double variance) {
  for (int step = 0; step < 80; ++step) {
    const int first = static_cast<int>(std::floor(middle_ - 6.0 * deviation_)) - 1,
              last = static_cast<int>(std::ceil(middle_ + 6.0 * deviation_)) + 1;
    double sum = 0.0, squares = 0.0;
    for (int i = first; i <= last; ++i) {
      const double light = pixel(i), place = i - mean;
      sum += light * place, squares += light * place * place;
    }
    const double square = deviation_ * deviation_ + 0.5 * (variance - (squares - sum * sum));
    middle_ -= 0.5 * sum;
    deviation_ = std::sqrt(std::max(square, least_deviation * least_deviation));
  }
}

double PixelGaussian::pixel(double place) const {
  const double x = (place - middle_) / deviation_, half = 0.5 / deviation_;
  return normal_share(x + half) - normal_share(x - half);
}

double PixelGaussian::light(double place, double width) const {
  const auto integral = [&](double offset) { return integrated_share((place - middle_ + offset) / deviation_); };
  const double wide = 0.5 * (1.0 + width), narrow = 0.5 * (1.0 - width);
  return deviation_ * (integral(wide) - integral(narrow) - integral(-narrow) + integral(-wide));
}

}  // namespace sturm
