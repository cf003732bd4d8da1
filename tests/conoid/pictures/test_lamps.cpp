// Lamps are so much brighter than what is beside them that a hundredth of a pixel of them shows: their rims in blur, by
// both predictors.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "conoid/pictures/flat_scene.h"
#include "conoid/pictures/lamp_reach.h"
#include "conoid/pictures/layered_predictor.h"

namespace sturm {
namespace {

using std::numbers::pi;

constexpr double lamp_slope = 4e-3;
constexpr double lamp_radiance = 40.0;

PicturePlane lamp_picture(int width, int height) {
  PicturePlane p;
  p.width = width;
  p.height = height;
  p.pixel_slope = lamp_slope;
  return p;
}

/// A lamp that fills the half of a card right of x = `edge_px` pixels from the middle, 2 m away, before nothing.
FlatScene half_lamp(double edge_px, double radiance = lamp_radiance) {
  const double z = -2.0, edge = edge_px * lamp_slope * 2.0;
  return FlatScene({{z, edge, 9.0, -9.0, 9.0, [radiance](double, double) { return radiance; }, true},
                    {z, -9.0, edge, -9.0, 9.0, [](double, double) { return 0.1; }}});
}

/// An eye whose blur at 2 m is a disc of `radius_px`.
SightField field_with_blur(double radius_px, int width = 32) {
  // 10 mm of radius: radius_px · slope / 0.01 D of defocus.
  const double defocus_D = radius_px * lamp_slope / 1e-2;
  return SightField(lamp_picture(width, 16),
                    Eye::with(Prescription{}, 2e-2, FixedAccommodation{0.5 + defocus_D, 1.0 / (0.5 + defocus_D)}),
                    std::nullopt);
}

/// Share of a unit disc beyond the distance s of its centre.
double beyond(double s) {
  s = std::clamp(s, -1.0, 1.0);
  return 0.5 - (std::asin(s) + s * std::sqrt(1.0 - s * s)) / pi;
}

/// Mean of beyond((x − edge)/r) over a pixel, i.e. how much of the blurred pixel the lamp right of `edge` fills.
double filled(double left, double edge, double radius) {
  double sum = 0.0;
  for (int k = 0; k < 1000; ++k) sum += beyond((edge - (left + (k + 0.5) / 1000.0)) / radius) / 1000.0;
  return sum;
}

Image lamps_by_passes(const FlatScene& scene, const SightField& field, int lamp_factor,
                      PassCounters* counters = nullptr) {
  PassSettings settings;
  settings.passes = 64;
  settings.lamp_factor = lamp_factor;
  const PassPrediction predicted =
      predict_by_passes(scene.sharp_view(field), 1, field, scene.first_hits(), scene.shader(), settings);
  if (counters) *counters = predicted.counters;
  return predicted.radiance;
}

Image lamps_by_layers(const FlatScene& scene, const SightField& field) {
  PassCounters counters;
  PassSettings settings;
  settings.passes = 16;
  const FragmentImage view = scene.sharp_view(field);
  return predict_by_layers(view, 1, field,
                           unseen_pieces(view, 1, field, scene.first_hits(), scene.shader(), settings, counters))
      .radiance;
}

/// Largest deviation of a row from the closed form, in radiances of the lamp.
double worst(const Image& image, int y, double edge_px, double radius_px) {
  double largest = 0.0;
  for (int x = 3; x < image.width - 3; ++x) {
    const double share = filled(x, 0.5 * image.width + edge_px, radius_px),
                 expected = share * lamp_radiance + (1.0 - share) * 0.1;
    largest = std::max(largest, std::abs(static_cast<double>(image.at(x, y)[0]) - expected) / lamp_radiance);
  }
  return largest;
}

TEST(Lamps, PassesStepsAreThoseOfTheManyPoints) {
  const double radius = 4.0;
  const FlatScene scene = half_lamp(0.0);
  const SightField field = field_with_blur(radius);
  PassCounters few, many;
  const Image coarse = lamps_by_passes(scene, field, 1, &few), fine = lamps_by_passes(scene, field, 16, &many);
  // An edge through N even points of a disc is off by O(N^-3/4), 0.044 of 64 and 0.0055 of 1024. Where a ray is less
  // than a 32nd of the pixel (more than half of its rays meet the lamp) the 64 stay, whose places in the pixel count as
  // well: twice as much.
  double dim = 0.0, dim_coarse = 0.0;
  for (int x = 3; x < 29; ++x) {
    const double share = filled(x, 16.0, radius);
    if (share > 0.4) continue;
    const double expected = share * lamp_radiance + (1.0 - share) * 0.1;
    dim = std::max(dim, std::abs(fine.at(x, 8)[0] - expected) / lamp_radiance);
    dim_coarse = std::max(dim_coarse, std::abs(coarse.at(x, 8)[0] - expected) / lamp_radiance);
  }
  EXPECT_LT(dim, 0.0055);
  EXPECT_GT(dim_coarse, 0.0055);  // else the test could not fail
  EXPECT_LT(worst(fine, 8, 0.0, radius), 2 * 0.044);
  EXPECT_EQ(few.lamp_pixels, 0);
  EXPECT_GT(many.lamp_pixels, 16 * 4);        // each row has the dark half of the blur at least: 4 px
  EXPECT_LT(many.lamp_pixels, 16 * (4 + 4));  // and the margin, rounded up, and the sharp pixel
  EXPECT_EQ(many.rays, 64 * (32 * 16 + 16 * many.lamp_pixels + 256 * many.bright_lamp_pixels));
}

TEST(Lamps, VeryBrightLampsGetStillMorePasses) {
  // A lamp 4e5 times as bright as all else fills a 1070th of the blur of these pixels: 1024 points meet it not at all,
  // once or twice, and a row of such pixels would be lamps and gaps. After at least 4 that meet it, or 16384, the pixel
  // is known to a quarter.
  const double radiance = 4e4, radius = 4.0, edge = -0.25;
  PassCounters counters;
  const Image image = lamps_by_passes(half_lamp(edge, radiance), field_with_blur(radius), 16, &counters);
  const double expected = filled(11.0, 16.0 + edge, radius) * radiance + 0.1;
  EXPECT_LT(expected, radiance / 1024);
  for (int y = 0; y < 16; ++y) EXPECT_NEAR(image.at(11, y)[0] / expected, 1.0, 0.25) << y;
  EXPECT_GE(counters.bright_lamp_pixels, 16);
  EXPECT_LT(counters.bright_lamp_pixels, counters.lamp_pixels / 2);  // most of the rim is met by 4 of 1024
}

TEST(Lamps, PassesDoNotMixALampWithWhatSharesItsPixelAndPlane) {
  // In focus, an edge inside of a pixel: only that pixel may have light of both.
  const double edge = 0.3;
  const FlatScene scene = half_lamp(edge);
  const SightField field = field_with_blur(0.0);
  const Image image = lamps_by_passes(scene, field, 16);
  for (int y = 0; y < 16; ++y) {
    EXPECT_NEAR(image.at(15, y)[0], 0.1f, 1e-6f);
    EXPECT_NEAR(image.at(17, y)[0], static_cast<float>(lamp_radiance), 1e-4f);
    // 64 places (more than half of them meet the lamp): an edge along an axis is off by O(log N/N).
    EXPECT_NEAR(image.at(16, y)[0] / lamp_radiance, 0.7 + 0.3 * 0.1 / lamp_radiance, std::log(64.0) / 64.0);
  }
}

TEST(Lamps, LayeredLampsLeakAsLittleBlurMakesThem) {
  // A lamp up to the border of its pixel and a disc of 0.39 px: from its middle it would not reach the next pixel. The
  // mean over that pixel is E[max(X, 0)] of the disc's projection, 2r/(3π).
  for (const double radius : {0.2, 0.39, 0.7}) {
    const Image image = lamps_by_layers(half_lamp(0.0), field_with_blur(radius));
    const double leak = 2.0 * radius / (3.0 * pi);
    // Midpoints of eighths: at most h²/8 times the variation of the edge profile's slope, 2/(πr) (Peano's kernel of a
    // cell).
    const double tolerance = 1.0 / 64 / 8 * 2.0 / (pi * radius);
    EXPECT_NEAR((image.at(15, 8)[0] - 0.1) / (lamp_radiance - 0.1), leak, tolerance) << radius;
    EXPECT_NEAR((image.at(16, 8)[0] - 0.1) / (lamp_radiance - 0.1), 1.0 - leak, tolerance) << radius;
  }
}

TEST(Lamps, LayeredLampsKeepTheirWidthInAnyBlur) {
  // Cells of 1/n of a pixel; the tolerance is that of LayeredLampsLeakAsLittleBlurMakesThem, inside and outside of the
  // lamp's pixel.
  const double edge = 0.25;
  for (const auto& [radius, n] : {std::pair{2.5, 4}, std::pair{9.0, 2}}) {
    const double tolerance = 2.0 / (n * n) / 8 * 2.0 / (pi * radius);
    const SightField field = field_with_blur(radius, 64);
    EXPECT_LT(worst(lamps_by_layers(half_lamp(edge), field), 8, edge, radius), tolerance) << radius;
  }
}

TEST(Lamps, APartOfAPixelIsSpreadFromWhereItIs) {
  // The lamp fills the right quarter of its pixel; with 0.1 px of blur nothing reaches the next pixel on the left.
  const Image near = lamps_by_layers(half_lamp(0.75), field_with_blur(0.1));
  EXPECT_NEAR(near.at(15, 8)[0], 0.1f, 1e-4f);
  EXPECT_NEAR((near.at(16, 8)[0] - 0.1) / (lamp_radiance - 0.1), 0.25, 2.0 / 64 / 8 * 2.0 / (pi * 0.1));  // in and out
}

TEST(Lamps, ALampThatTheSharpViewMissesIsAsLargeAsItIs) {
  // Fifths of a pixel, between the 4 × 4 places that the sharp view looks at. The rays that find it all meet it:
  // without a measure of its own it would be a whole pixel of lamp, 25 times too much light.
  const double z = -2.0, pixel = lamp_slope * 2.0, half = 0.1 * pixel, x = 0.5 * pixel, y = -0.5 * pixel,
               radiance = 4e3;
  const FlatScene scene(
      {{z, x - half, x + half, y - half, y + half, [radiance](double, double) { return radiance; }, true},
       {2 * z, -9.0, 9.0, -9.0, 9.0, [](double, double) { return 0.1; }}});
  const SightField field = field_with_blur(4.0);
  for (const Fragment& f : scene.sharp_view(field).fragments) ASSERT_FALSE(f.emits);
  double light = 0.0;
  for (const float value : lamps_by_layers(scene, field).pixels) light += (static_cast<double>(value) - 0.1) / 3.0;
  // 256 chief rays count a fifth of 16 columns and rows to one: (3/16)² … (4/16)² for 1/25.
  EXPECT_GE(light, radiance * 9.0 / 256 * 0.99);
  EXPECT_LE(light, radiance * 16.0 / 256 * 1.01);
}

TEST(Lamps, ReachIsTheBlurOfTheRim) {
  const FlatScene scene = half_lamp(0.0);
  const SightField field = field_with_blur(4.0);
  const Image reach = lamp_reach(scene.sharp_view(field), 1, field);
  EXPECT_EQ(reach.at(16, 8)[0], static_cast<float>(lamp_radiance));
  EXPECT_EQ(reach.at(11, 8)[0], static_cast<float>(lamp_radiance));  // 16.5 − 4 − 1.5 = 11.0
  EXPECT_EQ(reach.at(10, 8)[0], 0.0f);
  EXPECT_EQ(reach.at(26, 8)[0], 0.0f);  // inside of the lamp
}

}  // namespace
}  // namespace sturm
