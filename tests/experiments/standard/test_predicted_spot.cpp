// The picture of a small light that the report's viewer shows as the prediction: against what is known of an ellipse
// that a disc has spread.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/standard/predicted_spot.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::pi;

constexpr int resolution = 64;
constexpr double light = 1.5;  // radius [px]
constexpr double light_area = 7.0685834705770345;

struct Moments {
  double sum = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0,
         yy = 0.0;  // x to the right, y up, from the picture's middle [px]

  explicit Moments(const Image& image) {
    for (int row = 0; row < image.height; ++row)
      for (int column = 0; column < image.width; ++column) {
        const double w = image.at(column, row)[0], u = column + 0.5 - 0.5 * image.width,
                     v = 0.5 * image.height - row - 0.5;
        sum += w, x += w * u, y += w * v, xx += w * u * u, xy += w * u * v, yy += w * v * v;
      }
    for (double* m : {&x, &y, &xx, &xy, &yy}) *m /= sum;
  }
};

TEST(PredictedSpot, HasTheMomentsOfTheEllipseTheLightAndThePixel) {
  Eigen::Matrix2d map;
  map << 14.0, 5.0, 5.0, 6.0;
  const Image picture = predicted_spot(map, light, resolution);
  const Moments m(picture);
  EXPECT_NEAR(m.sum, light_area, 1e-5);  // 4096 floats of at most 0.1
  EXPECT_NEAR(m.x, 0.0, 2e-3);           // 512 points of the light: their mean is off by 1.5 px / 512 at most
  EXPECT_NEAR(m.y, 0.0, 2e-3);
  // map·mapᵀ/4 + 1.5²/4 + 1/12, by hand; the spiral's second moments are off by O(1/512) of 0.56, and the pixels' by
  // O(1/12²) on the rim.
  const double both = 0.5625 + 1.0 / 12.0;
  EXPECT_NEAR(m.xx, 55.25 + both, 0.02);
  EXPECT_NEAR(m.xy, 25.0, 0.02);  // up and to the right: a mirrored picture has −25
  EXPECT_NEAR(m.yy, 15.25 + both, 0.02);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) ASSERT_EQ(picture.pixels[i], picture.pixels[i - i % 3]);
}

TEST(PredictedSpot, InsideItIsTheLightsAreaOverThatOfTheEllipse) {
  const Image picture = predicted_spot(Eigen::Vector2d(12.0, 9.0).asDiagonal(), light, resolution);
  EXPECT_NEAR(picture.at(32, 32)[0], light_area / (pi * 12.0 * 9.0), 1e-7);  // rounding to float
  EXPECT_NEAR(picture.at(36, 29)[0], light_area / (pi * 12.0 * 9.0), 1e-7);
  EXPECT_EQ(picture.at(32 + 15, 32)[0], 0.0f);
}

TEST(PredictedSpot, AFocalLineIsAsBrightAsItsProjectedDisc) {
  // Unit disc onto a line of half length 20 px at 45°, up and to the right.
  Eigen::Matrix2d map;
  map << 10.0, 10.0, 10.0, 10.0;
  const Image picture = predicted_spot(map, light, resolution);
  EXPECT_NEAR(Moments(picture).sum, light_area, 1e-5);
  EXPECT_GT(picture.at(42, 21)[0], 0.0f);
  EXPECT_EQ(picture.at(42, 42)[0], 0.0f);
  // Where the line is crossed in the middle of the light: density 2/(π·20) per px times the light's width of 3 px,
  // averaged over the pixel, whose corners lie up to 0.7 px off the line: the mean of 2√(1.5² − h²) over it is 2.943 by
  // quadrature.
  EXPECT_NEAR(picture.at(32, 31)[0], 2.0 / (pi * 20.0) * 2.943, 0.01 * 0.0937);  // 512 points: 1 %
}

TEST(PredictedSpot, InPerfectFocusItIsTheLight) {
  const Image picture = predicted_spot(Eigen::Matrix2d::Zero(), light, resolution);
  EXPECT_NEAR(Moments(picture).sum, light_area, 1e-5);
  for (const auto& [x, y] : {std::pair(31, 31), {32, 31}, {31, 32}, {32, 32}})
    EXPECT_NEAR(picture.at(x, y)[0], 1.0,
                0.03);  // 512/7.07 points in a pixel, off by the spiral's discrepancy of one or two
  EXPECT_EQ(picture.at(35, 32)[0], 0.0f);
}

}  // namespace
}  // namespace sturm
