#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compare/images/image_comparison.h"
#include "compare/images/noise_floor.h"
#include "compare/images/regions.h"
#include "compare/metrics/stored_images.h"
#include "compare/statistics/random_draws.h"
#include "io/files/error.h"

namespace sturm {
namespace {

using testing::stored_image, testing::textured_image, testing::uniform_image;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// `image` with independent noise on every pixel and channel.
Image noisy(const Image& image, double deviation, std::uint64_t seed) {
  NormalDraws draws(seed);
  Image result = image;
  for (float& v : result.pixels) v += static_cast<float>(deviation * draws.next());
  return result;
}

const ImageMetric& named(const std::vector<ImageMetric>& metrics, const std::string& key) {
  for (const ImageMetric& m : metrics)
    if (m.key == key) return m;
  throw std::out_of_range(key);
}

TEST(ImageComparison, AMaskOfEverythingIsTheWholePicture) {
  const auto metrics = measure_images(stored_image("noise"), stored_image("reference"), {});
  Image all(160, 128, 1);
  std::fill(all.pixels.begin(), all.pixels.end(), 1.0f);
  ASSERT_EQ(metrics.size(), image_metric_names().size());
  for (const ImageMetric& m : metrics) {
    if (m.key.starts_with("ms_ssim")) {
      EXPECT_FALSE(m.value);  // 128 rows
      continue;
    }
    EXPECT_NEAR(*m.within(all), *m.value, 2e-6 * std::abs(*m.value)) << m.key;  // maps are stored in single precision
    EXPECT_EQ(m.map.pixels.empty(), m.key.ends_with("_trimmed")) << m.key;
    if (!m.map.pixels.empty()) {
      EXPECT_EQ(m.map.width + 2 * m.margin, 160) << m.key;
    }
    EXPECT_FALSE(m.within(Image(160, 128, 1))) << m.key;
  }
}

TEST(ImageComparison, MasksSeparateTheHalves) {
  const Image reference = textured_image(64, 64, 0.0);
  Image test = reference;
  for (int y = 0; y < 64; ++y)
    for (int x = 40; x < 64; ++x)
      for (int c = 0; c < 3; ++c) test.at(x, y)[c] *= 0.5f;
  Image left(64, 64, 1);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 24; ++x) *left.at(x, y) = 1.0f;
  ImageMetricSettings settings;
  settings.pixels_per_degree = 20.0;
  for (const ImageMetric& m : measure_images(test, reference, settings)) {
    if (m.key.starts_with("ms_ssim")) continue;  // the picture is too small for it
    if (m.key.starts_with("psnr")) {
      EXPECT_FALSE(m.within(left)) << m.key;  // infinite
      continue;
    }
    EXPECT_NEAR(*m.within(left), m.more_is_better ? 1.0 : 0.0, 1e-6) << m.key;
    EXPECT_GT(std::abs(*m.value - (m.more_is_better ? 1.0 : 0.0)), 1e-3) << m.key;
  }
}

TEST(NoiseFloor, SeedsOfOneViewAreNotDistinguished) {
  const Image scene = textured_image(128, 128, 0.0);
  const Image a = noisy(scene, 0.05, 1), a2 = noisy(scene, 0.05, 2), b = noisy(scene, 0.05, 3);
  const auto compared = measure_images(a, b, {}), floors = measure_images(a, a2, {});
  for (std::size_t i = 0; i < compared.size(); ++i) {
    const NoiseFloor f = noise_floor(compared[i], {&floors[i]});
    if (compared[i].map.pixels.empty()) continue;
    ASSERT_TRUE(f.z) << compared[i].key;
    EXPECT_LT(std::abs(*f.z), 4.0) << compared[i].key;  // 15 metrics at 4σ
    EXPECT_EQ(*f.value, *floors[i].value);
  }
}

TEST(NoiseFloor, ZOfEqualExpectationsIsStandardNormal) {
  double mean = 0.0, squares = 0.0;
  constexpr int trials = 500;
  NormalDraws draws(7);
  for (int t = 0; t < trials; ++t) {
    ImageMetric compared, floor;  // squared errors of noise, four blocks
    compared.map = floor.map = Image(64, 64, 1);
    compared.value = floor.value = 1.0;  // there is one; z is of the maps
    for (std::size_t i = 0; i < compared.map.pixels.size(); ++i) {
      const double a = draws.next(), a2 = draws.next(), b = draws.next();
      compared.map.pixels[i] = static_cast<float>((a - b) * (a - b));
      floor.map.pixels[i] = static_cast<float>((a - a2) * (a - a2));
    }
    const double z = *noise_floor(compared, {&floor}).z;
    mean += z / trials, squares += z * z / trials;
  }
  EXPECT_NEAR(mean, 0.0, 4.0 / std::sqrt(trials));
  EXPECT_NEAR(squares, 1.0, 4.0 * std::sqrt(2.0 / trials));  // 4σ of a variance
}

TEST(NoiseFloor, ABlockIsTwiceTheWindow) {
  // Two blocks tell, one does not.
  ImageMetric compared, floor;
  compared.map = floor.map = Image(64, 32, 1);
  compared.value = floor.value = 1.0;
  compared.map.pixels[0] = 1.0f;
  EXPECT_TRUE(noise_floor(compared, {&floor}).z);
  compared.window_px = 16;
  EXPECT_TRUE(noise_floor(compared, {&floor}).z);
  compared.window_px = 32;
  EXPECT_FALSE(noise_floor(compared, {&floor}).z);
  compared.window_px = 1;
  compared.value.reset();
  EXPECT_FALSE(noise_floor(compared, {&floor}).z);
}

TEST(NoiseFloor, ASmallDifferenceEverywhereIsDistinguished) {
  const Image scene = textured_image(192, 192, 0.0);
  Image other = scene;
  for (float& v : other.pixels) v += 0.03f;  // below the noise of a pixel
  const auto compared = measure_images(noisy(scene, 0.05, 1), noisy(other, 0.05, 3), {});
  const auto floors = measure_images(noisy(scene, 0.05, 1), noisy(scene, 0.05, 2), {});
  const auto other_floors = measure_images(noisy(other, 0.05, 3), noisy(other, 0.05, 4), {});
  // (Relative errors and ΔE₀₀ shrink with the brighter reference here.)
  for (const char* key : {"rmse_linear", "flip", "psnr_display_dB"}) {
    const ImageMetric &f = named(floors, key), &g = named(other_floors, key);
    EXPECT_GT(*noise_floor(named(compared, key), {&f}).z, 4.0) << key;
    EXPECT_GT(*noise_floor(named(compared, key), {&f, &g}).z, 4.0) << key;
    const bool more_is_better = named(compared, key).more_is_better;
    EXPECT_EQ(*noise_floor(named(compared, key), {&f, &g}).value,
              more_is_better ? std::min(*f.value, *g.value) : std::max(*f.value, *g.value));
  }
}

TEST(Regions, BlurOfAMyopeByHand) {
  // −2 D at the cornea, relaxed: |1/d − 2| D on a pupil of 2 mm radius: 1 m → 2 mrad, 0.5 m → 0, ∞ → 4 mrad. With −1 D
  // × 180 more the worse meridian is −3 D.
  Image depth(3, 1, 1);
  depth.pixels = {1.0f, 0.5f, static_cast<float>(infinity)};
  const Image blur = blur_semi_axis_px(depth, Eye::with({-2.0, 0.0, 180.0, 0.0}, 4e-3), 0.0, 1e-3);
  EXPECT_NEAR(blur.pixels[0], 2.0, 1e-6);
  EXPECT_NEAR(blur.pixels[1], 0.0, 1e-6);
  EXPECT_NEAR(blur.pixels[2], 4.0, 1e-6);
  EXPECT_NEAR(blur_semi_axis_px(depth, Eye::with({-2.0, -1.0, 180.0, 0.0}, 4e-3), 0.0, 1e-3).pixels[1], 2.0, 1e-6);
  EXPECT_NEAR(blur_semi_axis_px(depth, Eye::with({-2.0, 0.0, 180.0, 0.0}, 4e-3), 1.0, 1e-3).pixels[0], 4.0, 1e-6);
}

TEST(Regions, ASteepPlaneHasNoEdgesAndAStepHas) {
  Image depth(60, 40, 1);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x)
      *depth.at(x, y) = static_cast<float>(1.0 / (0.02 + 0.05 * (y + 1) + 0.01 * x));  // a floor up to 30 m
  EXPECT_EQ((Region{"", occlusion_edges(depth, nullptr)}.pixels()), 0u);
  for (int y = 0; y < 40; ++y)
    for (int x = 30; x < 60; ++x) *depth.at(x, y) *= 0.7f;
  const Image mask = occlusion_edges(depth, nullptr);
  EXPECT_EQ(*mask.at(29, 20), 1.0f);
  EXPECT_EQ(*mask.at(31, 20), 1.0f);
  EXPECT_EQ(*mask.at(20, 20), 0.0f);
  Image blur(60, 40, 1);
  std::fill(blur.pixels.begin(), blur.pixels.end(), 10.0f);
  EXPECT_EQ(*occlusion_edges(depth, &blur).at(20, 20), 1.0f);  // the two sides mix as far as the blur reaches
  EXPECT_EQ(*occlusion_edges(depth, &blur).at(10, 20), 0.0f);
}

TEST(Regions, FromLayers) {
  Image test = uniform_image(20, 12, 0.5f, 0.5f, 0.5f), reference = test;
  std::fill_n(test.at(3, 4), 3, 1.5f);
  std::fill_n(reference.at(5, 4), 3, 2.5f);
  RegionLayers layers;
  EXPECT_EQ(regions_of(test, reference, 1.0, layers).size(), 1u);  // highlights need no layer
  layers.depth = Image(20, 12, 1);
  layers.blur_px = Image(20, 12, 1);
  std::fill(layers.depth->pixels.begin(), layers.depth->pixels.end(), static_cast<float>(infinity));
  for (int x = 0; x < 20; ++x) *layers.blur_px->at(x, 0) = 1.5f;
  const auto regions = regions_of(test, reference, 1.0, layers);
  ASSERT_EQ(regions.size(), 4u);
  EXPECT_EQ(regions[0].name, "in_focus");
  EXPECT_EQ(regions[0].pixels(), 220u);
  EXPECT_EQ(regions[1].pixels(), 20u);
  EXPECT_EQ(regions[2].pixels(), 0u);
  EXPECT_EQ(regions[3].pixels(), 2u);
  EXPECT_EQ(regions_of(test, reference, 0.5, layers)[3].pixels(), 1u);
  layers.depth = Image(19, 12, 1);
  EXPECT_THROW(regions_of(test, reference, 1.0, layers), InputError);
}

}  // namespace
}  // namespace sturm
