#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/files/error.h"
#include "io/images/depth_map.h"

namespace sturm {
namespace {

Image stored_row(std::initializer_list<float> numbers) {
  Image row(static_cast<int>(numbers.size()), 1, 1);
  std::copy(numbers.begin(), numbers.end(), row.pixels.begin());
  return row;
}

DepthReading disparities(double focal_px, double baseline_m, double doffs_px) {
  DepthReading reading;
  reading.unit = DepthUnit::Disparity;
  reading.stereo = {focal_px, baseline_m, doffs_px};
  return reading;
}

TEST(DepthMap, DisparitiesAreDistancesByTheCalibration) {
  // 1000 px · 0.2 m = 200 px m, and 10 px are added: 40 px are 200/50 = 4 m, 90 px are 2 m, 390 px are 0.5 m.
  const DepthMap map = depth_of(stored_row({40, 90, 390}), disparities(1000.0, 0.2, 10.0), "d");
  EXPECT_DOUBLE_EQ(1.0 / map.vergence_D[0], 4.0);
  EXPECT_DOUBLE_EQ(1.0 / map.vergence_D[1], 2.0);
  EXPECT_DOUBLE_EQ(1.0 / map.vergence_D[2], 0.5);
  // Middlebury's motorcycle: f = 994.978 px, b = 193.001 mm, doffs = 31.086 px. 60 px: 192.03175/91.086 = 2.108246 m.
  EXPECT_NEAR(1.0 / depth_of(stored_row({60}), disparities(994.978, 0.193001, 31.086), "d").vergence_D[0], 2.108246,
              1e-6);
}

TEST(DepthMap, FactorsOfDisparitiesComeBeforeTheCalibration) {
  // Stored with 16 steps for a pixel: 640 is 40 px.
  DepthReading reading = disparities(1000.0, 0.2, 10.0);
  reading.scale = 1.0 / 16.0;
  EXPECT_DOUBLE_EQ(1.0 / depth_of(stored_row({640}), reading, "d").vergence_D[0], 4.0);
}

TEST(DepthMap, NoPixelIsBeyondInfinity) {
  // The principal points are 10 px apart the other way: 10 px are infinitely far, and 9 px nowhere.
  const DepthReading reading = disparities(1000.0, 0.2, -10.0);
  EXPECT_EQ(depth_of(stored_row({10}), reading, "d").vergence_D[0], 0.0);
  EXPECT_DOUBLE_EQ(depth_of(stored_row({50}), reading, "d").vergence_D[0], 0.2);
  EXPECT_THROW(depth_of(stored_row({50, 9}), reading, "d"), InputError);
}

TEST(DepthMap, HolesGetTheDepthOfTheirFarthestNeighbour) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  const DepthMap map = depth_of(stored_row({390, 0, infinite, 0, 40}), disparities(1000.0, 0.2, 10.0), "d");
  EXPECT_EQ(map.filled_holes, 3);
  // The first ring fills the two outer holes from their one known neighbour each; the one between gets the farther.
  EXPECT_DOUBLE_EQ(map.vergence_D[1], 2.0);
  EXPECT_DOUBLE_EQ(map.vergence_D[2], 0.25);
  EXPECT_DOUBLE_EQ(map.vergence_D[3], 0.25);
}

TEST(DepthMap, AHoleIsFilledFromTheRingThatReachesItFirst) {
  // Known at two corners, 2 m and 5 m: a pixel's ring is its distance from the nearer one, along rows or columns.
  constexpr int side = 9;
  Image stored(side, side, 1);
  *stored.at(0, 0) = 2.0f;
  *stored.at(side - 1, side - 1) = 5.0f;
  const DepthMap map = depth_of(stored, {}, "d");
  EXPECT_EQ(map.filled_holes, side * side - 2);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const int to_near = std::max(x, y), to_far = side - 1 - std::min(x, y);
      if (std::abs(to_near - to_far) < 2) continue;  // where the two grow together, the farther one goes on
      EXPECT_DOUBLE_EQ(map.vergence_D[static_cast<std::size_t>(y * side + x)], to_near < to_far ? 0.5 : 0.2)
          << x << " " << y;
    }
  EXPECT_DOUBLE_EQ(map.vergence_D[4 * side + 4], 0.2);
}

TEST(DepthMap, FarAwayIsNoHole) {
  DepthReading metres;
  const DepthMap map = depth_of(stored_row({std::numeric_limits<float>::infinity(), 0.5f}), metres, "d");
  EXPECT_EQ(map.filled_holes, 0);
  EXPECT_EQ(map.vergence_D[0], 0.0);
  DepthReading dioptres;
  dioptres.unit = DepthUnit::Dioptres;
  EXPECT_EQ(depth_of(stored_row({0.0f, 2.0f}), dioptres, "d").filled_holes, 0);
}

}  // namespace
}  // namespace sturm
