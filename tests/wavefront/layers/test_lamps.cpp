#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "wavefront/layers/guessed_background.h"
#include "wavefront/layers/lamps.h"
#include "wavefront/layers/layer_blur.h"
#include "wavefront/layers/ray_kernels.h"

namespace sturm {
namespace {

constexpr double lamps_pixel = 4e-4;
constexpr int side = 120;

LayeredPicture grey(double vergence_D) {
  LayeredPicture picture;
  picture.radiance = Image(side, side, 3);
  std::fill(picture.radiance.pixels.begin(), picture.radiance.pixels.end(), 0.2f);
  picture.vergence_D.assign(static_cast<std::size_t>(side) * side, vergence_D);
  picture.jump_D = 0.2;
  return picture;
}

/// The share of the pixel (x, y) that lies within a circle, by 64 × 64 points.
double covered(int x, int y, double centre_x, double centre_y, double radius) {
  constexpr int n = 64;
  int inside = 0;
  for (int i = 0; i < n * n; ++i)
    inside += std::hypot(x - 0.5 + (i % n + 0.5) / n - centre_x, y - 0.5 + (i / n + 0.5) / n - centre_y) < radius;
  return static_cast<double>(inside) / (n * n);
}

void add_round_lamp(LayeredPicture& picture, double centre_x, double centre_y, double radius, float light) {
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (std::hypot(x - centre_x, y - centre_y) > radius + 2.0) continue;
      const auto share = static_cast<float>(covered(x, y, centre_x, centre_y, radius));
      for (int c = 0; c < 3; ++c) picture.radiance.at(x, y)[c] += share * (light - picture.radiance.at(x, y)[c]);
    }
}

Image seen(LayeredPicture picture, double pupil_radius_px_per_D, int parts) {
  const KernelModel model =
      ray_kernels(Eye::with(Prescription{0.0, 0.0, 0.0, 0.0}, 2.0 * pupil_radius_px_per_D * lamps_pixel), 0.0,
                  lamps_pixel, {parts, false});
  picture.jump_D = 0.2;
  take_lamps(picture);
  const KernelBank bank(model, planes_for(picture.vergence_D, model.reach_px_per_D));
  add_guessed_background(picture, bank);
  BlurCounters work;
  return blur_layers(picture, bank, work);
}

TEST(Lamps, KeepTheirLight) {
  LayeredPicture picture = grey(1.0);
  add_round_lamp(picture, 60.3, 58.8, 2.4, 1e4f);
  double before = 0.0, after = 0.0;
  for (const float value : picture.radiance.pixels) before += value;
  ASSERT_TRUE(may_have_lamps(picture));
  take_lamps(picture);
  ASSERT_FALSE(picture.lamps.empty());
  for (const float value : picture.radiance.pixels) {
    EXPECT_NEAR(value, 0.2f, 1e-5);
    after += value;
  }
  for (const LampPixel& lamp : picture.lamps) after += lamp.rgb[0] + lamp.rgb[1] + lamp.rgb[2];
  EXPECT_NEAR(after / before, 1.0, 1e-6);
}

TEST(Lamps, OfOnePixelFillIt) {
  LayeredPicture picture = grey(1.0);
  std::fill_n(picture.radiance.at(50, 40), 3, 1e4f);
  take_lamps(picture);
  ASSERT_EQ(picture.lamps.size(), 1u);
  EXPECT_EQ(picture.lamps[0].places, all_places);
}

TEST(Lamps, LieWhereTheirNeighboursAreBright) {
  // Columns 50 and 51 are full, a quarter of column 52 is: its left one.
  LayeredPicture picture = grey(1.0);
  for (int y = 30; y < 34; ++y)
    for (int x = 50; x < 53; ++x) std::fill_n(picture.radiance.at(x, y), 3, x < 52 ? 1e4f : 2500.0f);
  take_lamps(picture);
  int found = 0;
  for (const LampPixel& lamp : picture.lamps)
    if (lamp.x == 52 && (lamp.y == 31 || lamp.y == 32)) {
      EXPECT_EQ(lamp.places, 0x1111);
      ++found;
    }
  EXPECT_EQ(found, 2);
}

TEST(Lamps, LeaveTheTextureBesideThemAlone) {
  // Every third pixel is five times as bright as the others; the lamp stands among them.
  LayeredPicture picture = grey(1.0);
  for (int y = 0; y < side; ++y)
    for (int x = y % 3; x < side; x += 3) std::fill_n(picture.radiance.at(x, y), 3, 1.0f);
  const LayeredPicture dark = picture;
  std::fill_n(picture.radiance.at(50, 40), 3, 1e4f);
  take_lamps(picture);
  ASSERT_EQ(picture.lamps.size(), 1u);
  for (int y = 30; y < 50; ++y)
    for (int x = 40; x < 60; ++x)
      if (x != 50 || y != 40) {
        EXPECT_EQ(picture.radiance.at(x, y)[0], dark.radiance.at(x, y)[0]) << x << " " << y;
      }
}

TEST(Lamps, OfAColourLeaveNoOtherColour) {
  // A red lamp on a grey wall: its pixel has no green light, nor may it get any.
  LayeredPicture picture = grey(1.0);
  picture.radiance.at(50, 40)[0] = 1e5f;
  picture.radiance.at(50, 40)[1] = picture.radiance.at(50, 40)[2] = 0.0f;
  take_lamps(picture);
  ASSERT_EQ(picture.lamps.size(), 1u);
  EXPECT_EQ(picture.lamps[0].rgb[1], 0.0f);
  EXPECT_EQ(picture.radiance.at(50, 40)[1], 0.0f);
  EXPECT_NEAR(picture.radiance.at(50, 40)[0], 0.2f, 1e-6);
}

TEST(Lamps, AChartHasNone) {
  LayeredPicture picture = grey(1.0);
  for (int y = 20; y < 60; ++y)
    for (int x = 20; x < 60; ++x) std::fill_n(picture.radiance.at(x, y), 3, 1.0f);
  EXPECT_FALSE(may_have_lamps(picture));
}

TEST(Lamps, ShineNoFartherThanTheirRim) {
  // A round lamp of radius 2.4 px, so bright that every pixel that it touches is white. Through a pupil of 2 px its
  // light reaches 4.4 px, and half a pixel's width more. Spread from whole pixels it would reach up to two pixels more.
  for (const auto& [x0, y0] : {std::pair(60.3, 58.8), {59.75, 60.5}, {60.0, 60.0}}) {
    LayeredPicture picture = grey(1.0);
    add_round_lamp(picture, x0, y0, 2.4, 1e6f);
    const Image test = seen(picture, 2.0, 4);
    int wrong = 0;
    for (int y = 40; y < 80; ++y)
      for (int x = 40; x < 80; ++x) {
        const double touched = covered(x, y, x0, y0, 4.4);
        if (touched == 0.0) wrong += test.at(x, y)[0] > 0.5f && std::hypot(x - x0, y - y0) > 4.4 + 0.9;
        if (touched > 0.2) wrong += test.at(x, y)[0] < 0.5f;
      }
    EXPECT_EQ(wrong, 0) << x0 << " " << y0;
  }
}

TEST(Lamps, BehindAnEdgeAreNotGuessedOn) {
  // A lamp beside a card before it. What is guessed behind the card is the wall, not more of the lamp.
  LayeredPicture picture = grey(0.2);
  for (int y = 0; y < side; ++y)
    for (int x = 60; x < side; ++x) picture.vergence_D[static_cast<std::size_t>(y) * side + x] = 2.0;
  for (int y = 50; y < 54; ++y)
    for (int x = 56; x < 60; ++x) std::fill_n(picture.radiance.at(x, y), 3, 1e4f);
  take_lamps(picture);
  const KernelModel model = ray_kernels(Eye::with(Prescription{0.0, 0.0, 0.0, 0.0}, 4e-3), 0.0, lamps_pixel, {});
  add_guessed_background(picture, KernelBank(model, {0.2, 2.0}));
  ASSERT_FALSE(picture.hidden.empty());
  for (const HiddenPixel& hidden : picture.hidden) EXPECT_NEAR(hidden.rgb[0], 0.2f, 1e-3);
}

TEST(Lamps, SeenInTheRimOfANearSurfaceAreTheFarOnes) {
  // The card's first column is half transparent, so it holds half of the lamp's light.
  LayeredPicture picture = grey(0.2);
  for (int y = 0; y < side; ++y)
    for (int x = 60; x < side; ++x) picture.vergence_D[static_cast<std::size_t>(y) * side + x] = 2.0;
  for (int y = 50; y < 54; ++y)
    for (int x = 55; x < 61; ++x) std::fill_n(picture.radiance.at(x, y), 3, x < 60 ? 1e4f : 5e3f);
  take_lamps(picture);
  ASSERT_FALSE(picture.lamps.empty());
  for (const LampPixel& lamp : picture.lamps) {
    EXPECT_EQ(lamp.vergence_D, 0.2);
    EXPECT_LT(lamp.x, 60);
  }
}

}  // namespace
}  // namespace sturm
