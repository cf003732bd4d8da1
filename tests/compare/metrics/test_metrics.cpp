#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "compare/metrics/relative_mse.h"
#include "compare/metrics/rmse.h"
#include "compare/metrics/ssim.h"
#include "io/files/error.h"
#include "io/images/exr.h"
#include "io/images/tone_map.h"
#include "support/source_folder.h"

namespace sturm {
namespace {

/// A reproducible pattern with structure at every scale, values in [0, 1].
Image pattern(int width, int height, int channels, double phase) {
  Image image(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c)
        image.at(x, y)[c] = static_cast<float>(0.5 + 0.25 * std::sin(0.31 * x + 0.05 * y * c + phase) +
                                               0.2 * std::cos(0.011 * x * y + phase));
  return image;
}

Image constant(int width, int height, float value) {
  Image image(width, height, 3);
  std::fill(image.pixels.begin(), image.pixels.end(), value);
  return image;
}

Image stored(const std::string& name) {
  return read_exr(STURM_SOURCE_DIR "/tests/reference/images/" + name + ".exr").layers.at("");
}

class MetricsOfStoredImages : public ::testing::TestWithParam<std::string> {};

TEST_P(MetricsOfStoredImages, EqualThoseOfOtherPrograms) {
  std::ifstream file(STURM_SOURCE_DIR "/tests/reference/images/values.json");
  const nlohmann::json values = nlohmann::json::parse(file)["values"][GetParam()];
  const auto expected = [&](const char* name) { return values[name].get<double>(); };
  const Image test = stored(GetParam()), reference = stored("reference");
  const Image test_display = to_display(test, 1.0), reference_display = to_display(reference, 1.0);
  constexpr double single = 2e-6;  // the other programs sum single precision values
  EXPECT_NEAR(rmse(test, reference), expected("rmse_rgb_linear"), single);
  EXPECT_NEAR(psnr_dB(test, reference), expected("psnr_rgb_linear"), 1e-4);
  EXPECT_NEAR(psnr_dB(test_display, reference_display), expected("psnr_rgb_srgb"), 1e-4);
  EXPECT_NEAR(relative_mse(test, reference).plain, expected("relmse_rgb_linear_eps0.01"), single);
  EXPECT_NEAR(ssim(test, reference).mean, expected("ssim_luma_linear"), 1e-5);
  EXPECT_NEAR(ssim(test_display, reference_display).mean, expected("ssim_luma_srgb"), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Reference, MetricsOfStoredImages, ::testing::Values("noise", "blur"));

TEST(Rmse, OfAConstantDifferenceIsTheDifference) {
  EXPECT_NEAR(rmse(constant(7, 5, 0.75f), constant(7, 5, 0.5f)), 0.25, 1e-15);
  EXPECT_NEAR(psnr_dB(constant(7, 5, 0.75f), constant(7, 5, 0.5f)), 20.0 * std::log10(4.0), 1e-12);
  EXPECT_NEAR(psnr_dB(constant(7, 5, 0.75f), constant(7, 5, 0.5f), 10.0), 20.0 * std::log10(40.0), 1e-12);
  EXPECT_EQ(psnr_dB(constant(7, 5, 0.5f), constant(7, 5, 0.5f)), std::numeric_limits<double>::infinity());
}

TEST(Rmse, HoldsTheWholeRangeOfHdr) {
  Image bright = constant(64, 64, 1e-8f);
  *bright.at(0, 0) = 1e8f;
  EXPECT_NEAR(rmse(bright, constant(64, 64, 0.0f)) / (1e8 / std::sqrt(64.0 * 64.0 * 3.0)), 1.0, 1e-7);
}

TEST(RelativeMse, ByHandAndTrimmed) {
  Image test = constant(50, 40, 0.6f);  // 2000 pixels: the worst two are left out
  const Image reference = constant(50, 40, 0.5f);
  const double usual = std::pow(0.6f - 0.5, 2) / 0.26, firefly = std::pow(100.0 - 0.5, 2) / 0.26;
  for (const int x : {3, 30}) std::fill_n(test.at(x, 7), 3, 100.0f);
  const RelativeMse r = relative_mse(test, reference);
  EXPECT_NEAR(r.plain, (1998.0 * usual + 2.0 * firefly) / 2000.0, 1e-9 * firefly);
  EXPECT_NEAR(r.trimmed, usual, 1e-12);
  std::fill_n(test.at(9, 9), 3, 100.0f);  // a third one stays
  EXPECT_NEAR(relative_mse(test, reference).trimmed, (1997.0 * usual + firefly) / 1998.0, 1e-9 * firefly);
}

TEST(Ssim, OfConstantsIsTheLuminanceTerm) {
  // variances vanish: (2ab + C₁)/(a² + b² + C₁)
  const double a = 0.25, b = 0.75, c1 = 1e-4;
  const Ssim s = ssim(constant(20, 15, 0.25f), constant(20, 15, 0.75f));
  EXPECT_NEAR(s.mean, (2 * a * b + c1) / (a * a + b * b + c1), 1e-12);
  EXPECT_EQ(s.map.width, 10);
  EXPECT_EQ(s.map.height, 5);
  EXPECT_EQ(s.map.channels, 1);
}

TEST(Ssim, OfOneImageIsOneAndOfItsNegativeIsBelowZero) {
  const Image image = pattern(40, 30, 3, 0.0);
  EXPECT_NEAR(ssim(image, image).mean, 1.0, 1e-12);
  Image negative = image;
  for (float& v : negative.pixels) v = 1.0f - v;
  EXPECT_LT(ssim(negative, image).mean, 0.0);
}

TEST(Ssim, MapStandsWhereTheDifferenceIs) {
  const Image reference = constant(60, 50, 0.5f);
  Image test = reference;
  std::fill_n(test.at(40, 12), 3, 1.0f);
  const Image map = ssim(test, reference).map;
  EXPECT_LT(*map.at(40 - 5, 12 - 5), 0.1f);
  EXPECT_NEAR(*map.at(40 - 5 + 6, 12 - 5), 1.0f, 1e-6f);  // one pixel beyond the window
  EXPECT_LT(*map.at(40 - 5, 12 - 5 + 5), 0.999f);         // still inside it
  EXPECT_NEAR(*map.at(12 - 5, 40 - 5), 1.0f, 1e-6f);      // rows and columns are not swapped
}

TEST(Ssim, SameBitsForAnyNumberOfThreads) {
  const Image a = pattern(150, 131, 3, 0.0), b = pattern(150, 131, 3, 0.4);
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return ssim(a, b);
  };
  const Ssim one = with_threads(1), four = with_threads(4);
  EXPECT_EQ(one.mean, four.mean);
  EXPECT_EQ(one.map.pixels, four.map.pixels);
}

TEST(Ssim, OneChannelIsItsOwnLuma) {
  const Image grey_a = pattern(30, 30, 1, 0.0), grey_b = pattern(30, 30, 1, 0.7);
  const auto as_rgb = [](const Image& grey) {
    Image rgb(grey.width, grey.height, 3);
    for (std::size_t i = 0; i < rgb.pixels.size(); ++i) rgb.pixels[i] = grey.pixels[i / 3];
    return rgb;
  };
  EXPECT_NEAR(ssim(grey_a, grey_b).mean, ssim(as_rgb(grey_a), as_rgb(grey_b)).mean, 1e-12);
}

TEST(SsimUncertainty, IsTheScatterOfTheBlocks) {
  // 8 × 8 blocks, half of them 1, half of them 0.5: the mean of 64 has the standard error 0.25/8
  Image map(128, 128, 1);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) *map.at(x, y) = (x / 16 + y / 16) % 2 ? 1.0f : 0.5f;
  EXPECT_NEAR(*ssim_mean_uncertainty(map, 3, 4000), 0.25 / 8.0, 0.05 * 0.25 / 8.0);  // 1/√8000 = 1.1 %, 4σ
  EXPECT_EQ(ssim_mean_uncertainty(map), ssim_mean_uncertainty(map));
  EXPECT_EQ(*ssim_mean_uncertainty(constant(64, 64, 1.0f)), 0.0);
  EXPECT_FALSE(ssim_mean_uncertainty(constant(16, 16, 1.0f)));
}

TEST(Metrics, RefuseWhatCannotBeCompared) {
  const Image image = pattern(20, 20, 3, 0.0);
  for (const Image& other : {pattern(20, 21, 3, 0.0), pattern(21, 20, 3, 0.0), pattern(20, 20, 1, 0.0), Image()}) {
    EXPECT_THROW(rmse(other, image), InputError);
    EXPECT_THROW(relative_mse(image, other), InputError);
    EXPECT_THROW(ssim(other, image), InputError);
  }
  EXPECT_THROW(rmse(Image(), Image()), InputError);
  EXPECT_THROW(ssim(pattern(10, 20, 3, 0.0), pattern(10, 20, 3, 0.0)), InputError);
  EXPECT_THROW(ssim(pattern(20, 20, 2, 0.0), pattern(20, 20, 2, 0.0)), InputError);
}

TEST(Metrics, NameTheNonFinitePixel) {
  const Image image = pattern(20, 20, 3, 0.0);
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    Image broken = image;
    broken.at(4, 17)[2] = bad;
    try {
      rmse(image, broken);
      FAIL();
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), ::testing::AllOf(::testing::HasSubstr("reference image"),
                                                 ::testing::HasSubstr("x = 4, y = 17, channel 2")));
    }
    EXPECT_THROW(ssim(broken, image), InputError);
    EXPECT_THROW(relative_mse(broken, image), InputError);
  }
}

}  // namespace
}  // namespace sturm
