#include <gtest/gtest.h>

#include <cmath>

#include "compare/metrics/slanted_edge.h"
#include "io/files/error.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::pi;

/// Edge along the direction `tilt` from the vertical, blurred by a Gaussian; each pixel is the mean of 16 × 16 points
/// of it.
Image edge_image(int width, int height, double tilt_deg, double sigma, bool steep = true) {
  Image image(width, height, 1);
  const double a = tilt_deg * pi / 180.0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      double sum = 0.0;
      for (int i = 0; i < 16; ++i)
        for (int j = 0; j < 16; ++j) {
          const double u = x + (j + 0.5) / 16 - 0.5 * width, v = y + (i + 0.5) / 16 - 0.5 * height;
          const double distance = steep ? u * std::cos(a) - v * std::sin(a) : v * std::cos(a) - u * std::sin(a);
          sum += 0.1 + 0.8 * 0.5 * std::erfc(-distance / (sigma * std::sqrt(2.0)));
        }
      *image.at(x, y) = static_cast<float>(sum / 256.0);
    }
  return image;
}

/// Gaussian blur and the pixel's square, seen along the normal of the edge.
double expected_mtf(double f, double sigma, double tilt_deg) {
  const auto sinc = [](double x) { return x == 0.0 ? 1.0 : std::sin(pi * x) / (pi * x); };
  const double a = tilt_deg * pi / 180.0;
  return std::exp(-2.0 * pi * pi * sigma * sigma * f * f) * sinc(f * std::cos(a)) * sinc(f * std::sin(a));
}

const double frequencies[] = {0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5};

TEST(SlantedEdge, MtfOfAKnownBlur) {
  for (const double sigma : {0.3, 0.7, 1.5})
    for (const double tilt : {5.0, -8.0}) {
      const EdgeMtf m = slanted_edge_mtf(edge_image(64, 80, tilt, sigma), {0, 0, 64, 80}, frequencies);
      EXPECT_NEAR(m.tilt_deg, tilt, 0.05);
      EXPECT_TRUE(m.steep);
      EXPECT_NEAR(m.step, 0.8, 0.01);
      // 0.01: the window flattens the line spread by 0.23 (2π σ/64)², 0.005 at most here; quarter-pixel bins are filled
      // unevenly.
      for (std::size_t i = 0; i < m.mtf.size(); ++i)
        EXPECT_NEAR(m.mtf[i], expected_mtf(frequencies[i], sigma, tilt), 0.01)
            << sigma << ' ' << tilt << ' ' << frequencies[i];
    }
}

TEST(SlantedEdge, RunsAcrossAndDarkensToo) {
  Image image = edge_image(90, 64, 6.0, 1.0, false);
  for (float& v : image.pixels) v = 1.0f - v;
  const EdgeMtf m = slanted_edge_mtf(image, {5, 2, 80, 60}, frequencies);
  EXPECT_FALSE(m.steep);
  EXPECT_NEAR(m.step, -0.8, 0.01);
  for (std::size_t i = 0; i < m.mtf.size(); ++i)
    EXPECT_NEAR(m.mtf[i], expected_mtf(frequencies[i], 1.0, 6.0), 0.01) << frequencies[i];
}

TEST(SlantedEdge, RefusesWhatHasNoEdge) {
  const Image image = edge_image(64, 64, 5.0, 1.0);
  EXPECT_THROW(slanted_edge_mtf(Image(64, 64, 1), {0, 0, 64, 64}, frequencies), InputError);
  EXPECT_THROW(slanted_edge_mtf(image, {0, 0, 15, 64}, frequencies), InputError);
  EXPECT_THROW(slanted_edge_mtf(image, {10, 0, 60, 64}, frequencies), InputError);
  EXPECT_THROW(slanted_edge_mtf(image, {33, 0, 30, 64}, frequencies), InputError);  // the edge leaves the area
}

}  // namespace
}  // namespace sturm
