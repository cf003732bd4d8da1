#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "io/files/error.h"
#include "support/block_test.h"

namespace sturm {
namespace {

/// Replicates of a smooth image with independent noise per pixel, whose size varies over the image.
std::vector<Image> noisy(int width, int height, int count, std::uint64_t seed, double noise = 0.2, double gain = 1.0) {
  std::mt19937_64 generator(seed);
  const auto normal_like = [&] {  // sum of 4 uniforms, unit variance
    double sum = -2.0;
    for (int i = 0; i < 4; ++i) sum += static_cast<double>(generator() >> 11) * 0x1p-53;
    return sum * std::sqrt(3.0);
  };
  std::vector<Image> images(count, Image(width, height, 3));
  for (Image& image : images)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < 3; ++c)
          image.at(x, y)[c] =
              static_cast<float>(gain * (1.0 + 0.01 * x) + noise * (1.0 + 2.0 * x / width) * normal_like());
  return images;
}

class BlockTestOf : public ::testing::TestWithParam<BlockVariance> {
 protected:
  BlockTestOptions options() const {
    BlockTestOptions o;
    o.variance = GetParam();
    return o;
  }
};

TEST_P(BlockTestOf, EqualImagesPass) {
  int rejected = 0;
  for (std::uint64_t run = 0; run < 40; ++run) {
    const BlockTest t = block_test(noisy(80, 64, 4, 2 * run), noisy(80, 64, 4, 2 * run + 1), options());
    rejected += !t.same();
    for (const auto& chi : t.chi_squared) EXPECT_GT(chi.p, 1e-4);  // 120 independent p values: 1.2 % altogether
  }
  EXPECT_LE(rejected, 1);  // family level 0.001: two of 40 have p = 8e-4
}

TEST_P(BlockTestOf, DeviatesHaveUnitVariance) {
  const BlockTest t = block_test(noisy(320, 256, 6, 11), noisy(320, 256, 6, 12), options());
  for (const auto& chi : t.chi_squared)
    EXPECT_NEAR(chi.value / chi.degrees, 1.0, 4.0 * std::sqrt(2.0 / chi.degrees));  // 4σ of χ²₃₂₀
}

TEST_P(BlockTestOf, OneBrighterBlockIsFoundWithItsSign) {
  std::vector<Image> a = noisy(80, 64, 8, 1), b = noisy(80, 64, 8, 2);
  for (Image& image : a)
    for (int y = 32; y < 48; ++y)
      for (int x = 48; x < 64; ++x) image.at(x, y)[1] += 0.5f;
  const BlockTest t = block_test(a, b, options());
  EXPECT_FALSE(t.same());
  EXPECT_EQ(t.worst_x, 3);
  EXPECT_EQ(t.worst_y, 2);
  EXPECT_EQ(t.worst_channel, 1);
  EXPECT_GT(t.z.at(3, 2)[1], 0.0f);
  EXPECT_LT(block_test(b, a, options()).z.at(3, 2)[1], 0.0f);
}

INSTANTIATE_TEST_SUITE_P(Variance, BlockTestOf,
                         ::testing::Values(BlockVariance::Replicates, BlockVariance::IndependentPixels));

TEST(BlockTest, ChiSquaredSeesASmallDifferenceThatIsEverywhere) {
  BlockTestOptions options;
  options.variance = BlockVariance::IndependentPixels;
  const BlockTest t = block_test(noisy(160, 128, 2, 5, 0.2, 1.015), noisy(160, 128, 2, 6), options);
  for (const auto& chi : t.chi_squared) EXPECT_LT(chi.p, 1e-6);
  for (const auto& ratio : t.mean_ratio) {
    EXPECT_NEAR(ratio.value, 1.015, 6.0 * std::max(ratio.standard_error, 0.3 / std::sqrt(160.0 * 128.0)));
    EXPECT_GT(ratio.standard_error, 0.0);
  }
}

TEST(BlockTest, ThresholdIsSidaksOverAllBlocksAndChannels) {
  const BlockTest t = block_test(noisy(40, 33, 2, 5), noisy(40, 33, 2, 6));
  EXPECT_EQ(t.z.width, 3);   // 16 + 16 + 8
  EXPECT_EQ(t.z.height, 3);  // 16 + 16 + 1
  EXPECT_NEAR(1.0 - std::pow(1.0 - std::erfc(t.threshold / std::sqrt(2.0)), 27), 0.001, 1e-9);
}

TEST(BlockTest, ImagesWithoutNoise) {
  const auto flat = [](float value) {
    Image image(20, 20, 1);
    std::fill(image.pixels.begin(), image.pixels.end(), value);
    return std::vector<Image>{image, image};
  };
  const BlockTest same = block_test(flat(0.5f), flat(0.5f));
  EXPECT_EQ(same.z_max, 0.0);
  EXPECT_EQ(same.chi_squared[0].p, 1.0);
  const BlockTest different = block_test(flat(0.5f), flat(0.25f));
  EXPECT_FALSE(different.same());
  EXPECT_TRUE(std::isfinite(different.z_max));
  EXPECT_EQ(different.mean_ratio[0].value, 2.0);
  EXPECT_EQ(different.mean_ratio[0].standard_error, 0.0);
}

TEST(BlockTest, RefusesTooFewReplicatesAndUnequalSizes) {
  EXPECT_THROW(block_test(noisy(20, 20, 1, 1), noisy(20, 20, 2, 2)), InputError);
  EXPECT_THROW(block_test(noisy(20, 20, 2, 1), {}), InputError);
  EXPECT_THROW(block_test(noisy(20, 20, 2, 1), noisy(21, 20, 2, 2)), InputError);
  std::vector<Image> broken = noisy(20, 20, 2, 1);
  broken[1].pixels[7] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(block_test(broken, noisy(20, 20, 2, 2)), InputError);
}

}  // namespace
}  // namespace sturm
