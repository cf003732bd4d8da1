// Who gets how many samples: Neyman's allocation, worked by hand.
#include <gtest/gtest.h>

#include "pathtrace/film/sample_planner.h"
#include "pathtrace/film/tile_error.h"

namespace sturm {
namespace {

/// Takes a planner through passes that double the samples from 32, with errors σ²/n; returns where each tile stops.
std::vector<std::uint32_t> samples_at_stop(SamplePlanner planner, const std::vector<double>& sigmas) {
  std::vector<std::uint32_t> stopped(sigmas.size(), 0);
  for (std::uint32_t n = 32; n <= (1u << 20); n *= 2) {
    for (std::size_t t = 0; t < sigmas.size(); ++t)
      if (planner.wants(t)) planner.measured(t, n, sigmas[t] * sigmas[t] / n);
    planner.decide();
    for (std::size_t t = 0; t < sigmas.size(); ++t)
      if (!planner.wants(t) && stopped[t] == 0) stopped[t] = n;
  }
  return stopped;
}

TEST(SamplePlanner, TilesGetSamplesInProportionToTheirDeviation) {
  // ⟨σ⟩ = (1·1 + 3·0.1)/4 = 0.325 (tiles of 64 and 192 pixels), r² = 1e-4: 3250 and 325 samples; the next doublings of
  // 32 are 4096 and 512.
  EXPECT_EQ(samples_at_stop({{64, 192}, 0.01, true}, {1.0, 0.1}), (std::vector<std::uint32_t>{4096, 512}));
  // The picture: (1/4096 + 3·0.01/512)/4 = 7.6e-5 ≤ 1e-4.
}

TEST(SamplePlanner, AQuietTileStopsAtOnceAndTheRestGoOn) {
  EXPECT_EQ(samples_at_stop({{64, 64}, 0.01, true}, {0.0, 1.0}),
            (std::vector<std::uint32_t>{32, 8192}));  // 0.5/1e-4 = 5000
}

TEST(SamplePlanner, WithoutTilesAllStopTogether) {
  // (1 + 0.01)/2/n ≤ 1e-4: n ≥ 5050.
  EXPECT_EQ(samples_at_stop({{64, 64}, 0.01, false}, {0.1, 1.0}), (std::vector<std::uint32_t>{8192, 8192}));
}

TEST(SamplePlanner, GoodEnoughIsGoodEnough) {
  EXPECT_EQ(samples_at_stop({{64, 64}, 0.5, true}, {0.1, 1.0}), (std::vector<std::uint32_t>{32, 32}));
}

TEST(TileError, ByHand) {
  // Two pixels side by side: means 1 and 3, their neighbourhood 2; half differences 0.1 and 0.2 in one channel, 0 in
  // the others.
  const std::vector<PixelPair> pixels{{{1.1, 1.0, 1.0}, {0.9, 1.0, 1.0}}, {{3.2, 3.0, 3.0}, {2.8, 3.0, 3.0}}};
  EXPECT_NEAR(tile_squared_error(pixels, 2), (0.01 + 0.04) / 4.01 / 6.0, 1e-15);
  // Of a row of four, the ends do not see each other: 0.01/(2² + 0.01), the mean of 1, 1 and 4 being 2.
  const std::vector<PixelPair> row{
      {{1, 0, 0}, {1, 0, 0}}, {{1.1, 0, 0}, {0.9, 0, 0}}, {{4, 0, 0}, {4, 0, 0}}, {{99, 0, 0}, {99, 0, 0}}};
  EXPECT_NEAR(tile_squared_error(row, 4), 0.01 / 4.01 / 12.0, 1e-15);
  // And of a column of the same.
  EXPECT_NEAR(tile_squared_error(row, 1), 0.01 / 4.01 / 12.0, 1e-15);
}

}  // namespace
}  // namespace sturm
