// The room of tests/reference/scene_plain as rendered here and by Cycles, block by block.
//
// Statistic. For a block and channel let x₁ … x_m be its means in m pictures of ours with independent seeds and y₁, y₂ those of the two
// reference pictures. Both are unbiased, with unequal and unknown variances (another sampler, 4096 samples against a few), so pooled equal
// variances would be wrong; the difference is studentised by
//     t = (x̄ − ȳ) / √(s_x²/m + s_y²/2),
// which follows Student's t with Welch and Satterthwaite's degrees of freedom (s_x²/m + s_y²/2)² / ((s_x²/m)²/(m−1) + (s_y²/2)²/1).
// s_y² has one degree of freedom only, but its share of the sum is small, so t stays close to m − 1 degrees of freedom. Means of 256 pixels
// times several samples are near enough to normal. 256 blocks × 3 channels are tested: with Šidák's correction every p-value must exceed
// 1 − (1 − 0.01)^(1/768). Channels of a block go together, which makes this conservative.
//
// Many small differences that no block shows alone show in the mean of t² over the (independent) blocks of one channel: E t² = ν/(ν − 2),
// E t⁴ = 3ν²/((ν − 2)(ν − 4)).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "pathtrace/render.h"
#include "support/scene_plain.h"
#include "support/scenes.h"
#include "support/student.h"

namespace sturm {
namespace {

constexpr int block = 16, blocks = 256;
constexpr int replicates = 16, samples = 8;
using BlockMeans = std::vector<Eigen::Vector3d>;

BlockMeans block_means(const Image& image) {
  BlockMeans means(blocks, Eigen::Vector3d::Zero());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int k = 0; k < 3; ++k)
        means[static_cast<std::size_t>(y / block * 16 + x / block)][k] += static_cast<double>(image.at(x, y)[k]) / (block * block);
  return means;
}

std::vector<BlockMeans> reference(const std::string& variant) {
  const auto file = testing::reference_file("scene_plain/block_means.json");
  std::vector<BlockMeans> seeds;
  for (const auto& seed : file["variants"][variant]["seeds"]) {
    BlockMeans means;
    for (const auto& b : seed) means.push_back(testing::vector3(b));
    seeds.push_back(means);
  }
  return seeds;
}

std::vector<BlockMeans> ours(const EyeRays<float>& rays) {
  const Scene scene(testing::scene_plain());
  const EyeCamera camera(testing::scene_plain_pose(), rays);
  std::vector<BlockMeans> pictures;
  for (int seed = 1; seed <= replicates; ++seed) {
    RenderSettings settings;
    settings.samples_per_pixel = samples;
    settings.max_bounces = 16;
    settings.seed = static_cast<std::uint64_t>(seed);
    pictures.push_back(block_means(render(scene, camera, settings).radiance));
  }
  return pictures;
}

struct Sample {
  double mean, variance_of_mean, degrees;
};

Sample summary(const std::vector<BlockMeans>& pictures, std::size_t b, int k) {
  const double n = static_cast<double>(pictures.size());
  double mean = 0.0, squares = 0.0;
  for (const BlockMeans& p : pictures) mean += p[b][k] / n;
  for (const BlockMeans& p : pictures) squares += std::pow(p[b][k] - mean, 2);
  return {mean, squares / (n - 1.0) / n, n - 1.0};
}

void expect_same_picture(const std::vector<BlockMeans>& a, const std::vector<BlockMeans>& b) {
  ASSERT_EQ(b.size(), 2u);
  ASSERT_EQ(b[0].size(), static_cast<std::size_t>(blocks));
  double least_p = 1.0;
  std::string worst;
  for (int k = 0; k < 3; ++k) {
    double mean_a = 0.0, mean_b = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < blocks; ++i) {
      const Sample x = summary(a, i, k), y = summary(b, i, k);
      mean_a += x.mean / blocks;
      mean_b += y.mean / blocks;
      const double variance = x.variance_of_mean + y.variance_of_mean;
      const double degrees =
          variance * variance / (x.variance_of_mean * x.variance_of_mean / x.degrees + y.variance_of_mean * y.variance_of_mean / y.degrees);
      const double t = (x.mean - y.mean) / std::sqrt(variance);
      squares += t * t / blocks;
      const double p = testing::student_two_sided(t, degrees);
      if (p < least_p) {
        least_p = p;
        worst = "block (" + std::to_string(i % 16) + ", " + std::to_string(i / 16) + ") channel " + std::to_string(k) +
                " t = " + std::to_string(t);
      }
    }
    EXPECT_NEAR(mean_a / mean_b, 1.0, 0.003) << "image mean of channel " << k;
    constexpr double nu = replicates - 1;
    const double expected = nu / (nu - 2.0), fourth = 3.0 * nu * nu / ((nu - 2.0) * (nu - 4.0));
    EXPECT_LT(squares, expected + 5.0 * std::sqrt((fourth - expected * expected) / blocks)) << "mean t² of channel " << k;
    ::testing::Test::RecordProperty("mean_t_squared_" + std::to_string(k), std::to_string(squares));
  }
  EXPECT_GT(least_p, 1.0 - std::pow(1.0 - 0.01, 1.0 / (3.0 * blocks))) << worst;
  ::testing::Test::RecordProperty("least_p", std::to_string(least_p));
}

TEST(Student, KnowsItsTables) {
  EXPECT_NEAR(testing::student_two_sided(12.706, 1.0), 0.05, 1e-5);
  EXPECT_NEAR(testing::student_two_sided(2.1314, 15.0), 0.05, 1e-5);
  EXPECT_NEAR(testing::student_two_sided(-4.0728, 15.0), 0.001, 1e-6);
  EXPECT_NEAR(testing::student_two_sided(1.95996, 1e7), 0.05, 1e-6);
}

TEST(ReferencePictures, Pinhole) {
  expect_same_picture(ours(testing::pinhole_rays()), reference("pinhole"));
}

TEST(ReferencePictures, LensOf20MillimetresFocusedAt105Centimetres) {
  expect_same_picture(ours(testing::focused_lens(0.02, 1.05)), reference("dof20"));
}

}  // namespace
}  // namespace sturm
