#include <gtest/gtest.h>

#include <cmath>

#include "compare/metrics/displacement.h"
#include "io/files/error.h"

namespace sturm {
namespace {

/// A smooth picture with structure in both directions, whose features stand `right` and `down` pixels further: 64 × 48
/// pixels.
Image picture(double right, double down, double gain = 1.0) {
  Image image(64, 48, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double u = x - right, v = y - down;
      const double value =
          0.5 + 0.2 * std::sin(0.31 * u + 0.5) + 0.15 * std::sin(0.27 * v - 0.2) + 0.1 * std::sin(0.2 * u + 0.23 * v);
      for (int c = 0; c < 3; ++c) image.at(x, y)[c] = static_cast<float>(gain * value);
    }
  return image;
}

/// Noise of a linear congruential generator, uniform with the given standard deviation.
Image noisy(Image image, unsigned seed, double deviation) {
  for (float& value : image.pixels) {
    seed = seed * 1664525u + 1013904223u;
    value += static_cast<float>((seed / 4294967296.0 - 0.5) * std::sqrt(12.0) * deviation);
  }
  return image;
}

TEST(Displacement, HasTheSignOfTheTestPictureAgainstTheReference) {
  const auto d = displacement_px(picture(0.5, 0.0), picture(0.0, 0.0));
  ASSERT_TRUE(d);
  // First order: the error is k²d²/24 of d, 0.004 at the highest k of 0.31 rad/px; central differences lack k²/6 = 1.6
  // %, and weigh less.
  EXPECT_NEAR(d->x(), 0.5, 0.012);
  EXPECT_NEAR(d->y(), 0.0, 0.005);
  const auto back = displacement_px(picture(0.0, 0.0), picture(0.3, -0.4));
  EXPECT_NEAR(back->x(), -0.3, 0.008);
  EXPECT_NEAR(back->y(), 0.4, 0.01);
}

TEST(Displacement, LostLightIsNone) {
  const auto d = displacement_px(picture(0.0, 0.0, 0.99), picture(0.0, 0.0));
  // The gain is fitted along with m of the mean of both, which is an exact multiple here: rounding of float pixels.
  EXPECT_NEAR(d->x(), 0.0, 1e-5);
  EXPECT_NEAR(d->y(), 0.0, 1e-5);
  const auto both = displacement_px(picture(0.25, 0.0, 0.9), picture(0.0, 0.0));
  EXPECT_NEAR(both->x(), 0.25, 0.006);
}

TEST(Displacement, NoiseDoesNotPullItAway) {
  constexpr int pictures = 40;
  double sum = 0.0, squares = 0.0;
  for (unsigned seed = 0; seed < pictures; ++seed) {
    const auto d =
        displacement_px(noisy(picture(0.2, 0.0), 2 * seed + 1, 0.05), noisy(picture(0.0, 0.0), 2 * seed + 2, 0.05));
    sum += d->x();
    squares += d->x() * d->x();
  }
  const double mean = sum / pictures, error = std::sqrt((squares / pictures - mean * mean) / pictures);
  EXPECT_LT(error, 0.005);
  EXPECT_NEAR(mean, 0.2, 4.0 * error + 0.006);  // 4σ, and the truncation of above
}

TEST(Displacement, NoneWithoutStructure) {
  EXPECT_FALSE(displacement_px(Image(64, 48, 3), Image(64, 48, 3)));
  EXPECT_FALSE(displacement_px(Image(31, 48, 3), Image(31, 48, 3)));
  EXPECT_THROW(displacement_px(Image(64, 48, 3), Image(48, 64, 3)), InputError);
}

}  // namespace
}  // namespace sturm
