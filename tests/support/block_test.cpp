#include "support/block_test.h"

#include <algorithm>
#include <cmath>

#include "compare/metrics/comparable.h"
#include "compare/statistics/statistics.h"
#include "io/files/error.h"

namespace sturm {

namespace {

struct Rectangle {
  int x0, y0, x1, y1;
  double pixels() const { return static_cast<double>(x1 - x0) * (y1 - y0); }
};

struct MeanAndVariance {
  double mean, variance_of_mean;
  double satterthwaite;  ///< Σ v²/ν over the independent terms v of the variance
};

MeanAndVariance from_values(const std::vector<double>& values) {
  const double n = static_cast<double>(values.size());
  double mean = 0.0, squares = 0.0;
  for (const double v : values) mean += v / n;
  for (const double v : values) squares += (v - mean) * (v - mean);
  const double variance = squares / (n * (n - 1.0));
  return {mean, variance, variance * variance / (n - 1.0)};
}

std::vector<double> block_means(std::span<const Image> replicates, const Rectangle& r, int channel) {
  std::vector<double> means;
  for (const Image& image : replicates) {
    double sum = 0.0;
    for (int y = r.y0; y < r.y1; ++y)
      for (int x = r.x0; x < r.x1; ++x) sum += image.at(x, y)[channel];
    means.push_back(sum / r.pixels());
  }
  return means;
}

MeanAndVariance measure(std::span<const Image> replicates, const Rectangle& r, int channel, BlockVariance kind) {
  MeanAndVariance block = from_values(block_means(replicates, r, channel));
  if (kind == BlockVariance::Replicates) return block;
  block.variance_of_mean = block.satterthwaite = 0.0;
  const double scale = 1.0 / (r.pixels() * r.pixels());
  std::vector<double> values(replicates.size());
  for (int y = r.y0; y < r.y1; ++y)
    for (int x = r.x0; x < r.x1; ++x) {
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = replicates[i].at(x, y)[channel];
      const MeanAndVariance pixel = from_values(values);
      block.variance_of_mean += scale * pixel.variance_of_mean;
      block.satterthwaite += scale * scale * pixel.satterthwaite;
    }
  return block;
}

double deviate(const MeanAndVariance& a, const MeanAndVariance& b) {
  const double difference = a.mean - b.mean, variance = a.variance_of_mean + b.variance_of_mean;
  if (difference == 0.0) return 0.0;
  const double satterthwaite = a.satterthwaite + b.satterthwaite;
  // Without any scatter the difference is certain; one degree of freedom only keeps the formula defined.
  const double degrees = satterthwaite > 0.0 ? variance * variance / satterthwaite : 1.0;
  return normal_equivalent_of_t(difference / std::sqrt(variance), degrees);
}

BlockTest::Ratio ratio_of_means(std::span<const Image> a, std::span<const Image> b, int channel) {
  const Rectangle all{0, 0, a[0].width, a[0].height};
  const MeanAndVariance ma = measure(a, all, channel, BlockVariance::Replicates),
                        mb = measure(b, all, channel, BlockVariance::Replicates);
  if (mb.mean == 0.0) return {0.0, 0.0};
  const double ratio = ma.mean / mb.mean;
  return {ratio, std::sqrt(ma.variance_of_mean + ratio * ratio * mb.variance_of_mean) / std::abs(mb.mean)};
}

}  // namespace

BlockTest block_test(std::span<const Image> a, std::span<const Image> b, const BlockTestOptions& options) {
  if (a.size() < 2 || b.size() < 2)
    throw InputError("", "", std::to_string(std::min(a.size(), b.size())) + " replicate(s)",
                     "at least two independent replicates of each image");
  if (options.block < 1)
    throw InputError("", "", "blocks of " + std::to_string(options.block) + " pixels", "at least 1 pixel");
  for (const Image& image : a) require_comparable(image, a[0]);
  for (const Image& image : b) require_comparable(image, a[0]);

  const int width = a[0].width, height = a[0].height, channels = a[0].channels;
  BlockTest test;
  test.z = Image((width + options.block - 1) / options.block, (height + options.block - 1) / options.block, channels);
  test.chi_squared.assign(channels, {0.0, static_cast<double>(test.z.width) * test.z.height, 0.0});
  for (int y = 0; y < test.z.height; ++y)
    for (int x = 0; x < test.z.width; ++x) {
      const Rectangle block{x * options.block, y * options.block, std::min(width, (x + 1) * options.block),
                            std::min(height, (y + 1) * options.block)};
      for (int c = 0; c < channels; ++c) {
        const double z = deviate(measure(a, block, c, options.variance), measure(b, block, c, options.variance));
        test.z.at(x, y)[c] = static_cast<float>(z);
        test.chi_squared[c].value += z * z;
        if (std::abs(z) > test.z_max)
          test.z_max = std::abs(z), test.worst_x = x, test.worst_y = y, test.worst_channel = c;
      }
    }
  test.threshold = normal_upper_quantile(0.5 * sidak_level(options.family_level, test.z.pixels.size()));
  for (int c = 0; c < channels; ++c) {
    test.chi_squared[c].p = chi_squared_upper_tail(test.chi_squared[c].value, test.chi_squared[c].degrees);
    test.mean_ratio.push_back(ratio_of_means(a, b, c));
  }
  return test;
}

}  // namespace sturm
