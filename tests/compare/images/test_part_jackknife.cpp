#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compare/images/part_jackknife.h"
#include "compare/statistics/jackknife.h"
#include "compare/statistics/statistics.h"

namespace sturm {
namespace {

using ::testing::ElementsAre;

constexpr double rounding = 1e-12;

Image map_of(int width, int height, std::initializer_list<float> values) {
  Image map(width, height, 1);
  map.pixels.assign(values);
  return map;
}

TEST(SharesOfMean, AddUpToIt) {
  const Image map = map_of(4, 2, {1, 2, 3, 4, 5, 6, 7, 8});
  EXPECT_THAT(shares_of_mean(map, 2), ElementsAre(14.0 / 8.0, 22.0 / 8.0));  // left: 1 + 2 + 5 + 6
  EXPECT_THAT(shares_of_mean(map, 1),
              ElementsAre(1 / 8.0, 2 / 8.0, 3 / 8.0, 4 / 8.0, 5 / 8.0, 6 / 8.0, 7 / 8.0, 8 / 8.0));
  EXPECT_THAT(shares_of_mean(map, 3), ElementsAre(36.0 / 8.0));  // too low and not wide enough for two
  EXPECT_THAT(shares_of_mean(map, 100), ElementsAre(36.0 / 8.0));
}

TEST(SharesOfMean, WhatIsLeftOverGoesToTheParts) {
  // Seven columns and five rows with room for 3 × 2 parts of at least two pixels: none has fewer, none is lost.
  Image map(7, 5, 1);
  std::fill(map.pixels.begin(), map.pixels.end(), 1.0f);
  const std::vector<double> shares = shares_of_mean(map, 2);
  ASSERT_EQ(shares.size(), 6u);
  double sum = 0.0;
  for (const double share : shares) {
    EXPECT_GE(share, 4.0 / 35.0 - rounding);
    sum += share;
  }
  EXPECT_NEAR(sum, 1.0, rounding);
}

TEST(PartJackknife, OfOnePartIsTheJackknife) {
  const std::vector<std::vector<double>> left_out = {{1.0}, {1.5}, {0.75}, {1.25}};
  const PartError error = jackknife_by_parts(left_out);
  EXPECT_NEAR(error.standard_error, jackknife_standard_error(std::vector{1.0, 1.5, 0.75, 1.25}), rounding);
  EXPECT_NEAR(error.degrees, 3.0, rounding);
}

TEST(PartJackknife, ByHand) {
  // Two replicates: left out in turn 1 and 3, mean 2, variance (2 − 1)/2·(1 + 1) = 1; the other part 0 and 4: 4.
  // Satterthwaite: 25/(1 + 16).
  const PartError error = jackknife_by_parts(std::vector<std::vector<double>>{{1.0, 4.0}, {3.0, 0.0}});
  EXPECT_NEAR(error.standard_error, std::sqrt(5.0), rounding);
  EXPECT_NEAR(error.degrees, 25.0 / 17.0, rounding);
  // Opposite noise in the two parts would cancel in the mean: that is not counted on. Without any noise there is no
  // degree of freedom.
  EXPECT_EQ(jackknife_by_parts(std::vector<std::vector<double>>{{1.0, 4.0}, {1.0, 4.0}}).standard_error, 0.0);
  EXPECT_EQ(jackknife_by_parts(std::vector<std::vector<double>>{{1.0, 4.0}, {1.0, 4.0}}).degrees, 0.0);
}

/// How often the mean of four replicates of 16 parts is more than `limit` normal deviates from the truth, by its own
/// error; the noise of part k is `growth` to the power of k.
double share_beyond(double limit, double growth, int trials) {
  constexpr int parts = 16, replicates = 4;
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  int beyond = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<std::vector<double>> values(replicates, std::vector<double>(parts)), left_out = values;
    double mean = 0.0;
    for (auto& replicate : values)
      for (int k = 0; k < parts; ++k) mean += (replicate[k] = std::pow(growth, k) * normal(random)) / replicates;
    for (int r = 0; r < replicates; ++r)
      for (int k = 0; k < parts; ++k) {
        double others = 0.0;
        for (int s = 0; s < replicates; ++s) others += s == r ? 0.0 : values[s][k];
        left_out[r][k] = others / (replicates - 1);
      }
    const PartError error = jackknife_by_parts(left_out);
    beyond += std::abs(normal_equivalent_of_t(mean / error.standard_error, error.degrees)) > limit;
  }
  return static_cast<double>(beyond) / trials;
}

TEST(PartJackknife, KeepsItsLevelWhateverTheNoiseOfTheParts) {
  // P(|z| > 3) = 0.0027: 4σ of 1e4 trials are 0.00208. Satterthwaite's degrees are too few, so that the share is less,
  // not more.
  constexpr int trials = 10000;
  for (const double growth : {1.0, 1.2, 2.0}) {
    const double share = share_beyond(3.0, growth, trials);
    EXPECT_LT(share, 0.0027 + 0.00208) << growth;
    EXPECT_GT(share, 0.0002) << growth;  // not so few that nothing is ever seen
  }
}

}  // namespace
}  // namespace sturm
