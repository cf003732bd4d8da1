#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compare/metrics/ciede2000.h"
#include "compare/metrics/flip.h"
#include "compare/metrics/flip_filters.h"
#include "compare/metrics/hdr_flip.h"
#include "compare/metrics/stored_images.h"
#include "io/files/error.h"
#include "io/images/tone_map.h"
#include "support/source_folder.h"

namespace sturm {
namespace {

using testing::stored_image, testing::uniform_image, testing::textured_image;

class FlipOfStoredImages : public ::testing::TestWithParam<std::string> {};

TEST_P(FlipOfStoredImages, EqualsThatOfAnotherProgram) {
  std::ifstream file(STURM_SOURCE_DIR "/tests/reference/images/values.json");
  const double expected = nlohmann::json::parse(file)["values"][GetParam()]["flip_mean_ppd67.02"];
  const Image test = to_display(stored_image(GetParam()), 1.0), reference = to_display(stored_image("reference"), 1.0);
  // Both compute in single precision; the other program filters in two dimensions: sums of ~500 terms, 1e-5 relative
  // each way.
  EXPECT_NEAR(flip(test, reference, flip_default_pixels_per_degree).mean, expected, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Reference, FlipOfStoredImages, ::testing::Values("noise", "blur"));

TEST(Flip, BlackAgainstWhiteIsTheEndOfItsScale) {
  // Worked by hand from the published constants: HyAB of black and white is 100, of green and blue (Hunt-adjusted)
  // 203.3; with the exponent 0.7 they are 25.119 and 41.276, the bend lies at 0.4 · 41.276: 0.95 + 0.05 (25.119
  // − 16.510)/(41.276 − 16.510).
  const Flip f = flip(uniform_image(40, 30, 1, 1, 1), uniform_image(40, 30, 0, 0, 0), 30.0);
  EXPECT_NEAR(f.mean, 0.96738, 2e-5);  // the hand-worked digits
  EXPECT_NEAR(*f.map.at(0, 0), *f.map.at(20, 15), 1e-6f);
}

TEST(Flip, GreenAgainstBlueIsOne) {
  EXPECT_NEAR(flip(uniform_image(20, 20, 0, 1, 0), uniform_image(20, 20, 0, 0, 1), 30.0).mean, 1.0, 1e-5);
}

TEST(Flip, OfOneImageIsZeroAndItIsSymmetric) {
  const Image a = textured_image(60, 50, 0.0), b = textured_image(60, 50, 0.3);
  EXPECT_EQ(flip(a, a, 20.0).mean, 0.0);
  EXPECT_NEAR(flip(a, b, 20.0).mean, flip(b, a, 20.0).mean, 1e-7);
  EXPECT_GT(flip(a, b, 20.0).mean, 0.05);
}

TEST(Flip, FromFarAwayDetailIsNotSeen) {
  // A checkerboard of single pixels against its mean in light: 60 px/deg put it at 30 cycles/deg and more, 4 px/deg
  // at 2.
  Image board(64, 64, 3);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) std::fill_n(board.at(x, y), 3, linear_to_srgb((x + y) % 2 ? 0.45f : 0.55f));
  const float grey = linear_to_srgb(0.5f);
  const Image flat = uniform_image(64, 64, grey, grey, grey);
  EXPECT_LT(*flip(board, flat, 120.0).map.at(32, 32), 0.2f * *flip(board, flat, 4.0).map.at(32, 32));
}

TEST(Flip, MapStandsWhereTheDifferenceIs) {
  const Image reference = uniform_image(60, 40, 0.5f, 0.5f, 0.5f);
  Image test = reference;
  test.at(45, 10)[0] = 1.0f;
  const Image map = flip(test, reference, 30.0).map;
  EXPECT_GT(*map.at(45, 10), 0.05f);
  EXPECT_EQ(*map.at(10, 35), 0.0f);
  EXPECT_EQ(*map.at(15, 10), 0.0f);
}

TEST(Flip, FiltersAreNormalisedForAnyDistance) {
  for (const double ppd : {0.3, 1.2, 18.0, 67.0, 200.0}) {
    const FeatureFilters f = feature_filters(ppd);
    double positive = 0.0, negative = 0.0, edge = 0.0;
    for (const float w : f.point) (w > 0 ? positive : negative) += w;
    for (const float w : f.edge) edge += std::abs(w);
    EXPECT_NEAR(positive, 1.0, 1e-6) << ppd;
    EXPECT_NEAR(negative, -1.0, 1e-6) << ppd;
    EXPECT_NEAR(edge, 2.0, 1e-6) << ppd;
    for (const GaussianSum& sum : contrast_filters(ppd)) {
      double total = 0.0;
      for (const auto& term : sum.terms)
        for (const float w : term.weights) total += term.share * w;
      EXPECT_NEAR(total, 1.0, 1e-5) << ppd;
    }
  }
}

TEST(Flip, SameBitsForAnyNumberOfThreads) {
  const Image a = textured_image(90, 71, 0.0), b = textured_image(90, 71, 0.4);
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return flip(a, b, 30.0);
  };
  const Flip one = with_threads(1), four = with_threads(4);
  EXPECT_EQ(one.mean, four.mean);
  EXPECT_EQ(one.map.pixels, four.map.pixels);
}

TEST(Flip, NeedsThreeChannelsAndOneSize) {
  EXPECT_THROW(flip(Image(8, 8, 1), Image(8, 8, 1), 30.0), InputError);
  EXPECT_THROW(flip(uniform_image(8, 8, 0, 0, 0), uniform_image(8, 9, 0, 0, 0), 30.0), InputError);
}

TEST(HdrFlip, OneExposureIsFlipAfterTheToneCurve) {
  const Image a = textured_image(40, 40, 0.0), b = textured_image(40, 40, 0.2);
  const auto mapped = [](const Image& image) {
    Image result = image;
    // The fit as K. Narkowicz prints it, of 0.6 · 2^1.5 times the value.
    for (float& v : result.pixels) {
      const double x = 0.6 * 2.8284271247461903 * v;
      v = linear_to_srgb(static_cast<float>(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14)));
    }
    return result;
  };
  const double expected = flip(mapped(a), mapped(b), 25.0).mean;
  EXPECT_NEAR(hdr_flip(a, b, 25.0, {1.5, 1.5, 1}).mean, expected, 1e-6);  // single precision, encoded to sRGB and back
}

TEST(HdrFlip, TakesTheWorstExposureOfEachPixel) {
  // A difference in the shadows that only the long exposure shows, and one in a highlight that only the short one does.
  Image reference = uniform_image(64, 32, 0.001f, 0.001f, 0.001f), test = reference;
  for (int y = 8; y < 24; ++y)
    for (int x = 8; x < 24; ++x) {
      std::fill_n(test.at(x, y), 3, 0.002f);
      std::fill_n(reference.at(x + 32, y), 3, 400.0f);
      std::fill_n(test.at(x + 32, y), 3, 800.0f);
    }
  const Flip all = hdr_flip(test, reference, 20.0, {-9.0, 9.0, 2});
  const Flip shortest = hdr_flip(test, reference, 20.0, {-9.0, -9.0, 1}),
             longest = hdr_flip(test, reference, 20.0, {9.0, 9.0, 1});
  EXPECT_EQ(*all.map.at(16, 16), *longest.map.at(16, 16));
  EXPECT_EQ(*all.map.at(48, 16), *shortest.map.at(48, 16));
  EXPECT_GT(*all.map.at(16, 16), 2.0f * *shortest.map.at(16, 16));
  EXPECT_GT(*all.map.at(48, 16), 2.0f * *longest.map.at(48, 16));
}

TEST(HdrFlip, ExposuresPutBrightestAndMedianAtTheTargetBrightness) {
  Image reference = uniform_image(11, 10, 0.0f, 0.0f, 0.0f);
  for (int i = 0; i < 99; ++i)
    std::fill_n(reference.pixels.begin() + 3 * i, 3, 0.25f);  // 99 of 110; the black ones do not count
  std::fill_n(reference.at(10, 9), 3, 64.0f);
  const ExposureRange range = hdr_flip_exposures(reference);
  EXPECT_NEAR(aces_tone_curve(std::exp2(range.start_stops) * 64.0), 0.85, 1e-9);
  EXPECT_NEAR(aces_tone_curve(std::exp2(range.stop_stops) * 0.25), 0.85, 1e-9);
  EXPECT_EQ(range.count, 8);  // 64/0.25 = 2^8
  EXPECT_EQ(hdr_flip_exposures(uniform_image(4, 4, 0, 0, 0)).count, 1);
  EXPECT_EQ(hdr_flip_exposures(uniform_image(4, 4, 3, 3, 3)).count, 2);
}

TEST(Ciede2000, EqualsThePublishedPairs) {
  std::ifstream file(STURM_SOURCE_DIR "/tests/reference/ciede2000_pairs.csv");
  std::string line;
  int pairs = 0;
  while (std::getline(file, line)) {
    if (line.empty() || !std::isdigit(static_cast<unsigned char>(line[0]))) continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    int number;
    Lab a, b;
    double expected;
    fields >> number >> a[0] >> a[1] >> a[2] >> b[0] >> b[1] >> b[2] >> expected;
    ASSERT_TRUE(fields) << line;
    EXPECT_NEAR(ciede2000_difference(a, b), expected, 0.5e-4 + 1e-9) << number;  // printed with four decimals
    EXPECT_NEAR(ciede2000_difference(b, a), expected, 0.5e-4 + 1e-9) << number;
    ++pairs;
  }
  EXPECT_EQ(pairs, 34);
}

TEST(Ciede2000, OfDisplayColours) {
  // Pure sRGB red, green and blue in L*a*b* (D65) as every table of them prints: (53.24, 80.09, 67.20), (87.73,
  // −86.18, 83.18), (32.30, 79.19, −107.86).
  const double expected = ciede2000_difference({53.24, 80.09, 67.20}, {32.30, 79.19, -107.86});
  const Ciede2000 d = ciede2000(uniform_image(5, 4, 1, 0, 0), uniform_image(5, 4, 0, 0, 1));
  EXPECT_NEAR(d.mean, expected, 0.01);  // two decimals of the tables
  EXPECT_NEAR(ciede2000(uniform_image(5, 4, 0, 1, 0), uniform_image(5, 4, 0, 0, 1)).mean,
              ciede2000_difference({87.73, -86.18, 83.18}, {32.30, 79.19, -107.86}), 0.01);
  EXPECT_EQ(ciede2000(uniform_image(5, 4, 1, 0, 0), uniform_image(5, 4, 1, 0, 0)).mean, 0.0);
  Image test = uniform_image(5, 4, 0, 0, 0);
  test.at(3, 1)[1] = 1.0f;
  EXPECT_GT(*ciede2000(test, uniform_image(5, 4, 0, 0, 0)).map.at(3, 1), 50.0f);
  EXPECT_EQ(*ciede2000(test, uniform_image(5, 4, 0, 0, 0)).map.at(1, 3), 0.0f);
}

}  // namespace
}  // namespace sturm
