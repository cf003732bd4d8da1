#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "compare/metrics/ms_ssim.h"
#include "compare/metrics/pixel_errors.h"
#include "compare/metrics/stored_images.h"

namespace sturm {
namespace {

using testing::textured_image, testing::uniform_image;

/// The definition of [Wang2003] word by word: full two-dimensional windows, one pixel after the other.
double by_definition(const Image& a, const Image& b) {
  const double beta[] = {0.0448, 0.2856, 0.3001, 0.2363, 0.1333};
  int width = a.width, height = a.height;
  const auto grey = [](const Image& image) {
    std::vector<double> y;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3)
      y.push_back(0.2126 * image.pixels[i] + 0.7152 * image.pixels[i + 1] + 0.0722 * image.pixels[i + 2]);
    return y;
  };
  std::vector<double> x = grey(a), y = grey(b);
  double window[11][11], total = 0.0;
  for (int i = 0; i < 11; ++i)
    for (int j = 0; j < 11; ++j) total += window[i][j] = std::exp(-((i - 5) * (i - 5) + (j - 5) * (j - 5)) / 4.5);
  double product = 1.0;
  for (int scale = 0; scale < 5; ++scale) {
    double contrast_structure = 0.0, whole = 0.0;
    for (int row = 5; row < height - 5; ++row)
      for (int column = 5; column < width - 5; ++column) {
        double mx = 0, my = 0, xx = 0, yy = 0, xy = 0;
        for (int i = -5; i <= 5; ++i)
          for (int j = -5; j <= 5; ++j) {
            const double w = window[i + 5][j + 5] / total, p = x[(row + i) * width + column + j],
                         q = y[(row + i) * width + column + j];
            mx += w * p, my += w * q, xx += w * p * p, yy += w * q * q, xy += w * p * q;
          }
        const double cs = (2 * (xy - mx * my) + 9e-4) / (xx - mx * mx + yy - my * my + 9e-4);
        contrast_structure += cs;
        whole += cs * (2 * mx * my + 1e-4) / (mx * mx + my * my + 1e-4);
      }
    const double n = (width - 10.0) * (height - 10.0);
    product *= std::pow((scale == 4 ? whole : contrast_structure) / n, beta[scale]);
    std::vector<double> x2, y2;
    for (int row = 0; row < height / 2; ++row)
      for (int column = 0; column < width / 2; ++column) {
        const int i = 2 * row * width + 2 * column;
        x2.push_back((x[i] + x[i + 1] + x[i + width] + x[i + width + 1]) / 4);
        y2.push_back((y[i] + y[i + 1] + y[i + width] + y[i + width + 1]) / 4);
      }
    x = x2, y = y2, width /= 2, height /= 2;
  }
  return product;
}

TEST(MsSsim, EqualsItsDefinitionSlow) {
  const Image a = textured_image(183, 178, 0.0);
  Image b = textured_image(183, 178, 0.0);
  for (std::size_t i = 0; i < b.pixels.size(); ++i)
    b.pixels[i] = 0.9f * b.pixels[i] + 0.05f * static_cast<float>((i / 7) % 3);
  EXPECT_NEAR(ms_ssim(b, a)->value, by_definition(b, a), 1e-9);  // rounding of differences of squares
}

TEST(MsSsim, OfConstantsIsTheCoarsestLuminanceTerm) {
  // Contrast and structure are 1; what is left is ((2ab + C₁)/(a² + b² + C₁))^0.1333.
  const double a = 0.25, b = 0.75, c1 = 1e-4;
  const Image x = uniform_image(180, 176, 0.25f, 0.25f, 0.25f), y = uniform_image(180, 176, 0.75f, 0.75f, 0.75f);
  EXPECT_NEAR(ms_ssim(x, y)->value, std::pow((2 * a * b + c1) / (a * a + b * b + c1), 0.1333), 1e-9);
}

TEST(MsSsim, NeedsRoomForAWindowAtTheCoarsestScale) {
  EXPECT_FALSE(ms_ssim(uniform_image(175, 300, 0, 0, 0), uniform_image(175, 300, 0, 0, 0)));
  EXPECT_EQ(ms_ssim(uniform_image(176, 176, 0, 0, 0), uniform_image(176, 176, 0, 0, 0))->value, 1.0);
}

TEST(MsSsim, MapAndMaskStandWhereTheDifferenceIs) {
  const Image reference = textured_image(400, 200, 0.0);
  Image test = reference;
  for (int y = 40; y < 160; ++y)
    for (int x = 260; x < 380; ++x)
      for (int c = 0; c < 3; ++c) test.at(x, y)[c] = 0.5f;
  const MsSsim m = *ms_ssim(test, reference);
  const Image map = m.local_map(400, 200);
  EXPECT_LT(*map.at(320, 100), 0.5f);
  EXPECT_GT(*map.at(80, 100), 0.999f);
  Image left(400, 200, 1), all(400, 200, 1);
  std::fill(all.pixels.begin(), all.pixels.end(), 1.0f);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 120; ++x) *left.at(x, y) = 1.0f;
  EXPECT_NEAR(*m.within(left), 1.0, 1e-6);
  EXPECT_NEAR(*m.within(all), m.value, 1e-6);  // maps are stored in single precision
  EXPECT_FALSE(m.within(Image(400, 200, 1)));
}

TEST(Smape, ByHand) {
  Image test = uniform_image(2, 1, 0.5f, 0.0f, 1.0f), reference = uniform_image(2, 1, 0.25f, 0.0f, 3.0f);
  EXPECT_NEAR(smape(test, reference), (0.25 / 0.76 + 0.0 + 2.0 / 4.01) / 3.0, 1e-12);
  EXPECT_NEAR(smape(reference, test), smape(test, reference), 1e-15);
  test.pixels[0] = -0.5f;  // signs of both count
  EXPECT_NEAR(symmetric_relative_errors(test, reference)[0], (0.75 / 0.76 + 2.0 / 4.01) / 3.0, 1e-12);
}

}  // namespace
}  // namespace sturm
