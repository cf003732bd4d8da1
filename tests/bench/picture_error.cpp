#include "bench/picture_error.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sturm::bench {

namespace {

constexpr int block = 16;
constexpr double largest_radiance = 5.0, dark = 0.01, trimmed_share = 0.001;

void require_same_size(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height || a.channels < 3 || b.channels < 3)
    throw std::invalid_argument("pictures of different sizes, or without three channels");
}

double square(double x) {
  return x * x;
}

/// Sum over a rectangle of the mean of the pictures, and the variance of that sum.
struct Total {
  double sum = 0.0, variance = 0.0;
};

Total total(const std::vector<Image>& pictures, int left, int top, int width, int height, int channel) {
  const auto n = static_cast<double>(pictures.size());
  Total result;
  for (int y = top; y < top + height; ++y)
    for (int x = left; x < left + width; ++x) {
      double mean = 0.0, squares = 0.0;
      for (const Image& picture : pictures) mean += static_cast<double>(picture.at(x, y)[channel]) / n;
      for (const Image& picture : pictures) squares += square(static_cast<double>(picture.at(x, y)[channel]) - mean);
      result.sum += mean;
      result.variance += squares / (n - 1.0) / n;
    }
  return result;
}

/// |z| that the largest of n normal numbers exceeds with probability p, by bisection of the complementary error
/// function.
double largest_of_normals(int n, double p) {
  const double each = 1.0 - std::pow(1.0 - p, 1.0 / n);
  double low = 0.0, high = 40.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (std::erfc(middle / std::sqrt(2.0)) > each ? low : high) = middle;
  }
  return low;
}

}  // namespace

double trimmed_relative_error(const Image& picture, const Image& reference) {
  require_same_size(picture, reference);
  std::vector<double> errors;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const float *value = picture.at(x, y), *expected = reference.at(x, y);
      double radiance = 0.0, error = 0.0;
      for (int k = 0; k < 3; ++k) {
        const double r = static_cast<double>(expected[k]);
        radiance += r / 3.0;
        error += square(static_cast<double>(value[k]) - r) / (r * r + dark) / 3.0;
      }
      if (radiance <= largest_radiance) errors.push_back(error);
    }
  std::sort(errors.begin(), errors.end());
  errors.resize(errors.size() - static_cast<std::size_t>(trimmed_share * static_cast<double>(errors.size())));
  double sum = 0.0;
  for (const double e : errors) sum += e;
  return sum / static_cast<double>(errors.size());
}

Agreement agreement(const std::vector<Image>& ours, const std::vector<Image>& theirs) {
  if (ours.size() < 2 || theirs.size() < 2) throw std::invalid_argument("agreement needs two pictures of each side");
  for (const std::vector<Image>* side : {&ours, &theirs})
    for (const Image& picture : *side) require_same_size(picture, ours.front());
  const int width = ours.front().width, height = ours.front().height;
  Agreement result{};
  double squares = 0.0;
  for (int k = 0; k < 3; ++k) {
    const Total a = total(ours, 0, 0, width, height, k), b = total(theirs, 0, 0, width, height, k);
    result.mean_ratio[k] = a.sum / b.sum;
    result.standard_error[k] =
        result.mean_ratio[k] * std::hypot(std::sqrt(a.variance) / a.sum, std::sqrt(b.variance) / b.sum);
    for (int top = 0; top + block <= height; top += block)
      for (int left = 0; left + block <= width; left += block) {
        const Total c = total(ours, left, top, block, block, k), d = total(theirs, left, top, block, block, k);
        const double variance = c.variance + d.variance, difference = c.sum - d.sum;
        // Inside an emitter nothing varies but the rounding of stored pixels.
        const double z = difference / std::sqrt(variance + square(1e-6 * (c.sum + d.sum)));
        squares += z * z;
        result.largest_z = std::max(result.largest_z, std::abs(z));
        ++result.blocks;
      }
  }
  result.rms_z = std::sqrt(squares / result.blocks);
  result.largest_z_expected_0_01 = largest_of_normals(result.blocks, 0.01);
  return result;
}

}  // namespace sturm::bench
