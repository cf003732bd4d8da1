#include <gtest/gtest.h>

#include "experiments/run/layer_sum.h"

namespace sturm {
namespace {

constexpr int width = 120, height = 80, edge = 60;
constexpr double pixel = 4e-4;

/// Everything is as bright; the left half stands at 2 D, the right half is far away.
SurfacesPicture two_halves() {
  SurfacesPicture surfaces;
  surfaces.picture.radiance = Image(width, height, 3);
  surfaces.picture.jump_D = 0.5;
  std::fill(surfaces.picture.radiance.pixels.begin(), surfaces.picture.radiance.pixels.end(), 0.4f);
  for (int i = 0; i < width * height; ++i) surfaces.picture.vergence_D.push_back(i % width < edge ? 2.0 : 0.0);
  return surfaces;
}

Eye in_focus_at(double vergence_D) {
  return Eye::with(Prescription{-vergence_D, 0.0, 0.0, 0.0}, 5e-3);
}

TEST(LayerSum, BrightensWhatHidesAndDarkensWhatIsHidden) {
  // The near half is sharp. The far half's blur of 2 D · 2.5 mm = 12.5 px lays half of its light on either side of the
  // edge: beside it the near half shows its own light and half of the other's, the far half lacks the half that the
  // near one would have hidden. Of the strip of a disc of radius r within x of its middle the share is
  // (asin(x/r) + x/r √(1 − x²/r²))·2/π: pixels' middles lie half a pixel from the edge.
  const Image sum = sum_of_layers(two_halves(), in_focus_at(2.0), pixel, {.kind = PredictionKind::DepthPsf});
  const double at = 0.5 / 12.5, within = (std::asin(at) + at * std::sqrt(1.0 - at * at)) / 3.14159265358979;
  EXPECT_NEAR(sum.at(edge - 1, 40)[0], 0.4 * (1.5 - within), 0.004);  // kernels are drawn on pixels
  EXPECT_NEAR(sum.at(edge, 40)[0], 0.4 * (0.5 + within), 0.004);
  for (const int far_from_edge : {20, 100}) EXPECT_NEAR(sum.at(far_from_edge, 40)[0], 0.4f, 1e-5);
}

TEST(LayerSum, OfOneSurfaceIsItsBlur) {
  SurfacesPicture surfaces = two_halves();
  surfaces.picture.vergence_D.assign(surfaces.picture.vergence_D.size(), 1.0);
  const Image sum = sum_of_layers(surfaces, in_focus_at(2.0), pixel, {.kind = PredictionKind::DepthPsf});
  for (const float value : sum.pixels) ASSERT_NEAR(value, 0.4f, 1e-5);
}

}  // namespace
}  // namespace sturm
