// Pixels with a small ellipse are copied instead of spread: the same picture to rounding.
#include <gtest/gtest.h>

#include <cmath>

#include "conoid/pictures/image_predictor.h"

namespace sturm {
namespace {

/// Bright and dark pixels at depths about the focus at infinity.
SharpView chequered(int oversampling, double pixel_slope) {
  const int side = 24 * oversampling;
  SharpView view{Image(side, side, 3), Image(side, side, 1), 0, pixel_slope / oversampling, oversampling};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      for (int k = 0; k < 3; ++k) view.radiance.at(x, y)[k] = (x + y) % 2 ? 100.0f : 0.25f * static_cast<float>(1 + k);
      *view.depth.at(x, y) = x < side / 2 ? 40.0f : 90.0f;
    }
  return view;
}

TEST(SharpSpots, CopyingIsSpreadingToRounding) {
  const Eye eye = Eye::with({0.0, -0.01, 30.0}, 3e-3);
  for (const int oversampling : {1, 2, 4}) {
    const SharpView view = chequered(oversampling, 1.5e-3);  // 0.035 px at 40 m
    const Prediction copied = predict_image(view, eye, 0.0, {0.5, 0.05}),
                     spread = predict_image(view, eye, 0.0, {0.5, 0.0});
    EXPECT_EQ(copied.counters.splatted_pixels, 0);
    EXPECT_EQ(spread.counters.sharp_pixels, 0);
    EXPECT_EQ(copied.counters.sharp_pixels, spread.counters.splatted_pixels);
    for (std::size_t i = 0; i < copied.radiance.pixels.size(); ++i)  // one rounding to float
      ASSERT_NEAR(copied.radiance.pixels[i], spread.radiance.pixels[i], 0x1p-23f * copied.radiance.pixels[i]);
  }
}

TEST(SharpSpots, APinholesEllipsesCanBeSpreadToo) {
  const SharpView view = chequered(1, 1.5e-3);
  const Eye pinhole = Eye::with({-3.0, -1.0, 10.0}, 0.0);
  const Prediction copied = predict_image(view, pinhole, 0.0, {0.5, 0.05}),
                   spread = predict_image(view, pinhole, 0.0, {0.5, 0.0});
  for (std::size_t i = 0; i < copied.radiance.pixels.size(); ++i)  // one rounding to float
    ASSERT_NEAR(copied.radiance.pixels[i], spread.radiance.pixels[i], 0x1p-23f * copied.radiance.pixels[i]);
}

}  // namespace
}  // namespace sturm
