#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "pathtrace/film/film.h"
#include "pathtrace/sampling/owen_sobol.h"

namespace sturm {
namespace {

// A float sum stands still at 2²⁴ samples of 1.
TEST(PixelStatistics, LosesNothingIn2To25Samples) {
  PixelStatistics pixel;
  const float low = 1.0f, high = 1.0f + 0x1p-20f;
  for (int i = 0; i < (1 << 24); ++i) {
    pixel.add({low, 1e-8f, 0.0f});
    pixel.add({high, 1e-8f, 1e8f});
  }
  EXPECT_EQ(pixel.count(), 1u << 25);
  // Each of n updates rounds at half a unit, 1.1e−16; their random walk is √n times that, 6.4e−13 relative.
  EXPECT_NEAR(pixel.mean(0) - 1.0, 0x1p-21, 1e-12);
  EXPECT_NEAR(pixel.variance(0), 0x1p-42, 1e-6 * 0x1p-42);
  EXPECT_NEAR(pixel.mean(1), static_cast<double>(1e-8f), 1e-12 * 1e-8);
  EXPECT_NEAR(pixel.variance(1), 0.0, 1e-28);
  EXPECT_NEAR(pixel.mean(2), 0.5e8, 1e-12 * 1e8);
  EXPECT_NEAR(pixel.variance(2), 0.25e16, 1e-6 * 0.25e16);
}

TEST(PixelStatistics, SmallValuesSurviveBesideLargeOnes) {
  // One sample of 1e8 among 2²⁰ of 1e−8: the mean is 1e8/n + 1e−8 and a float sum would have lost the second term.
  PixelStatistics with, without;
  with.add({1e8f, 0, 0});
  without.add({1e8f, 0, 0});
  for (int i = 1; i < (1 << 20); ++i) {
    with.add({1e-8f, 0, 0});
    without.add({0, 0, 0});
  }
  // Rounding of a mean that falls from 1e8: Σ 1e8/k · 1.1e−16 over k, as a random walk about 1e8 · 1.1e−16 · 1.3 in the
  // sum of n samples.
  EXPECT_NEAR((with.mean(0) - without.mean(0)) * (1 << 20), 1e-8 * (1 << 20), 1e-6);
}

TEST(PixelStatistics, VarianceAgreesWithTwoPasses) {
  std::vector<float> values;
  for (std::uint32_t i = 0; i < 100000; ++i)  // log-uniform over 1e−8 … 1e8
    values.push_back(static_cast<float>(std::pow(10.0, 16.0 * unit_double(owen_sobol::mixed(i)) - 8.0)));
  PixelStatistics pixel;
  long double sum = 0, squares = 0;
  for (float v : values) pixel.add({v, 1000.0f + v * 1e-8f, -v}), sum += v;
  const long double n = values.size(), mean = sum / n;
  for (float v : values) squares += (v - mean) * (v - mean);
  EXPECT_NEAR(pixel.mean(0), static_cast<double>(mean), 1e-13 * static_cast<double>(mean));
  EXPECT_NEAR(pixel.variance(0), static_cast<double>(squares / (n - 1)),
              1e-12 * static_cast<double>(squares / (n - 1)));
  EXPECT_EQ(pixel.mean(2), -pixel.mean(0));
  EXPECT_EQ(pixel.variance(2), pixel.variance(0));
}

TEST(PixelStatistics, FewSamples) {
  PixelStatistics pixel;
  EXPECT_EQ(pixel.mean(0), 0.0);
  EXPECT_EQ(pixel.variance(0), 0.0);
  pixel.add({3.0f, 0, 0});
  EXPECT_EQ(pixel.mean(0), 3.0);
  EXPECT_EQ(pixel.variance(0), 0.0);
  pixel.add({5.0f, 0, 0});
  EXPECT_EQ(pixel.mean(0), 4.0);
  EXPECT_EQ(pixel.variance(0), 2.0);
}

TEST(FirstHitStatistics, DepthIsTheNearestAndTheRestAreMeans) {
  FirstHitStatistics pixel;
  EXPECT_TRUE(std::isinf(pixel.depth()));
  pixel.add({1, 0, 0}, {0, 1, 0}, 2.0f);
  pixel.add({0, 0, 0}, {0, 0, 1}, 1.0f);
  pixel.add({1, 0, 1}, {0, 0, 1}, 3.0f);
  pixel.add_miss();
  EXPECT_EQ(pixel.depth(), 1.0f);
  EXPECT_DOUBLE_EQ(pixel.albedo(0), 0.5);
  EXPECT_DOUBLE_EQ(pixel.albedo(2), 0.25);
  EXPECT_DOUBLE_EQ(pixel.normal(1), 0.25);
  EXPECT_DOUBLE_EQ(pixel.normal(2), 0.5);
}

}  // namespace
}  // namespace sturm
