#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "wavefront/layers/layer_blur.h"
#include "wavefront/layers/layer_detail.h"
#include "wavefront/layers/ray_kernels.h"

namespace sturm {
namespace {

LayeredPicture picture_of(int width, int height, const std::function<float(int, int)>& value) {
  LayeredPicture picture;
  picture.radiance = Image(width, height, 3);
  picture.vergence_D.assign(static_cast<std::size_t>(width) * height, 1.0);
  picture.jump_D = 0.5;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) std::fill_n(picture.radiance.at(x, y), 3, value(x, y));
  return picture;
}

/// Of the columns from `left` up to `right`, from the row `top` up to `bottom`.
std::vector<Detail> detail_of(const LayeredPicture& picture, int left, int right, int top, int bottom) {
  LayerDetail layer(picture.radiance, picture.vergence_D, picture.coverage, picture.jump_D, left, right, top);
  std::vector<Detail> detail;
  for (int y = top; y < bottom; ++y) {
    const std::span<const Detail> row = layer.next_row();
    detail.insert(detail.end(), row.begin(), row.end());
  }
  return detail;
}

std::vector<Detail> detail_of(const LayeredPicture& picture) {
  return detail_of(picture, 0, picture.radiance.width, 0, picture.radiance.height);
}

/// The same of one pixel and colour, neighbour by neighbour.
float plain_detail(const LayeredPicture& picture, int x, int y, int c) {
  const auto value = [&](int u, int v) { return picture.radiance.at(u, v)[c]; };
  const auto joined = [&](int u, int v, int s, int t) {
    if (s < 0 || t < 0 || s >= picture.radiance.width || t >= picture.radiance.height) return false;
    const auto i = static_cast<std::size_t>(v * picture.radiance.width + u),
               j = static_cast<std::size_t>(t * picture.radiance.width + s);
    return std::min(picture.coverage[i], picture.coverage[j]) > 0.0f &&
           std::abs(picture.vergence_D[i] - picture.vergence_D[j]) <= picture.jump_D;
  };
  float sum = 0.0f;
  for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
    const int u = x + dx, v = y + dy;
    if (!joined(x, y, u, v) || value(x, y) == value(u, v)) continue;
    const float difference = value(x, y) - value(u, v), limit = std::min(value(x, y), value(u, v)) / 4.0f;
    float beside = 0.0f;
    if (joined(x, y, x - dx, y - dy)) beside = std::abs(value(x, y) - value(x - dx, y - dy));
    if (joined(u, v, u + dx, v + dy)) beside = std::max(beside, std::abs(value(u, v) - value(u + dx, v + dy)));
    const float share = std::clamp((beside / std::abs(difference) - 0.2f) / 0.25f, 0.0f, 1.0f);
    sum += std::clamp(share * difference / 12.0f, -limit, limit);
  }
  return sum;
}

TEST(LayerDetail, IsTheSameInAnyWindow) {
  LayeredPicture picture =
      picture_of(23, 19, [](int x, int y) { return static_cast<float>((x * x * 7 + y * 13 + x * y) % 11); });
  picture.coverage.assign(picture.vergence_D.size(), 1.0f);
  for (std::size_t i = 0; i < picture.vergence_D.size(); ++i) {
    if (i * 7 % 31 < 9) picture.vergence_D[i] = 3.0;
    if (i % 29 == 0) picture.coverage[i] = 0.0f;
  }
  for (const auto& [left, right, top, bottom] :
       {std::array{0, 23, 0, 19}, {5, 18, 4, 15}, {1, 22, 1, 18}, {22, 23, 18, 19}}) {
    const std::vector<Detail> detail = detail_of(picture, left, right, top, bottom);
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x)
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(
              detail[static_cast<std::size_t>((y - top) * (right - left) + x - left)][static_cast<std::size_t>(c)],
              plain_detail(picture, x, y, c), 1e-6)
              << x << " " << y;
  }
}

TEST(LayerDetail, IsATwelfthOfTheSecondDifferences) {
  // x² has the second difference 2 along x and none along y.
  const LayeredPicture picture = picture_of(5, 3, [](int x, int) { return 50.0f + static_cast<float>(x * x); });
  EXPECT_NEAR(detail_of(picture)[5 + 2][0], -2.0f / 12.0f, 1e-5);
  EXPECT_NEAR(detail_of(picture)[5 + 0][0], -1.0f / 12.0f, 1e-5);  // one neighbour beyond the border is missing
}

TEST(LayerDetail, DoesNotCrossEdgesNorHoles) {
  LayeredPicture picture = picture_of(4, 1, [](int x, int) { return static_cast<float>(1 << x); });
  EXPECT_NEAR(detail_of(picture)[1][0], -1.0f / 12.0f, 1e-6);  // of 1, 2, 4
  picture.vergence_D[2] = picture.vergence_D[3] = 3.0;
  EXPECT_EQ(detail_of(picture)[1][0], 0.0f);
  picture.vergence_D.assign(4, 1.0);
  picture.coverage = {1.0f, 1.0f, 0.0f, 1.0f};
  EXPECT_EQ(detail_of(picture)[1][0], 0.0f);
}

TEST(LayerDetail, StepsBetweenPixelsStay) {
  // Of a step that lies within the third pixel the two halves count.
  for (const float middle : {1.0f, 1.5f, 2.0f}) {
    const LayeredPicture picture = picture_of(5, 1, [&](int x, int) { return x < 2 ? 1.0f : x > 2 ? 2.0f : middle; });
    EXPECT_NEAR(detail_of(picture)[1][0], middle == 1.5f ? -0.5f / 12.0f : 0.0f, 1e-6) << middle;
  }
}

TEST(LayerDetail, KeepsLightAndMakesNoneNegative) {
  const LayeredPicture picture = picture_of(40, 30, [](int x, int y) {
    return (x * 7 + y * 11) % 5 == 0 ? 1e3f : 0.1f * static_cast<float>((x * 3 + y) % 4);
  });
  const std::vector<Detail> detail = detail_of(picture);
  double sum = 0.0;
  for (std::size_t i = 0; i < detail.size(); ++i) {
    sum += detail[i][0];
    EXPECT_GE(picture.radiance.pixels[3 * i] + detail[i][0], 0.0f);
  }
  EXPECT_NEAR(sum, 0.0, 1e-4);  // of 240 lamps of 1000, in single precision
}

TEST(LayerDetail, StripesKeepTheContrastThatTheBlurLeavesThem) {
  // A disc of radius r leaves 2 J₁(kr)/(kr) of stripes of period 2π/k. Here k = 0.7, r = 1.5 px; linear sharing alone
  // would take another k²/12 = 4 % of them.
  constexpr double k = 0.7, r = 1.5, pixel = 4e-4;
  LayeredPicture picture =
      picture_of(300, 40, [&](int x, int) { return static_cast<float>(0.5 + 0.1 * std::cos(k * x)); });
  picture.shows_detail = true;
  // In focus at 0 D, so that 1 D of error over a radius of r px.
  const KernelModel model = ray_kernels(Eye::with(Prescription{0.0, 0.0, 0.0, 0.0}, 2.0 * r * pixel), 0.0, pixel, {});
  BlurCounters work;
  const Image seen = blur_layers(picture, KernelBank(model, {1.0}), work);
  const double left = 2.0 * std::cyl_bessel_j(1.0, k * r) / (k * r);
  for (int x = 100; x < 200; ++x) EXPECT_NEAR(seen.at(x, 20)[0], 0.5 + 0.1 * left * std::cos(k * x), 4e-4) << x;
}

TEST(LayerDetail, DoesNothingInFocus) {
  LayeredPicture picture = picture_of(300, 40, [](int x, int y) { return static_cast<float>((x * 7 + y * 3) % 5); });
  picture.shows_detail = true;
  const KernelModel model = ray_kernels(Eye::with(Prescription{-1.0, 0.0, 0.0, 0.0}, 4e-3), 0.0, 4e-4, {});
  BlurCounters work;
  EXPECT_EQ(blur_layers(picture, KernelBank(model, {1.0}), work).pixels, picture.radiance.pixels);
}

/// The share of detail that a disc of so many pixels shows through the parts of a pupil.
float share_of_disc(double radius_px, int parts) {
  constexpr double pixel = 4e-4;
  const Eye eye = Eye::with(Prescription{0.0, 0.0, 0.0, 0.0}, 2.0 * radius_px * pixel);
  return KernelBank(ray_kernels(eye, 0.0, pixel, {parts, false}), {1.0}).detail_share(0, 0);
}

TEST(LayerDetail, BelongsToNarrowBlurOnly) {
  // The flank of a disc of radius r is 2πr px long and 1/(πr²) high, spread over two pixels by the shares of its rays:
  // a steepness of about 1/(πr³), 0.0025 at 5 px and 0.0009 at 7 px. Parts of the pupil make up the same disc.
  for (const int parts : {1, 8}) {
    EXPECT_NEAR(share_of_disc(2.0, parts), 1.0f, 0.02f) << parts;
    EXPECT_NEAR(share_of_disc(4.0, parts), 1.0f, 0.02f) << parts;
    EXPECT_GT(share_of_disc(5.5, parts), 0.3f) << parts;
    EXPECT_LT(share_of_disc(5.5, parts), 0.8f) << parts;
    for (const double radius : {7.3, 9.0, 14.0}) EXPECT_EQ(share_of_disc(radius, parts), 0.0f) << parts;
  }
}

TEST(LayerDetail, BelongsToEachColourByItsOwnBlur) {
  // By chromatic aberration the errors of red, green and blue are 0.27, -0.03 and -0.68 D beyond those 0.3 D of the
  // target. At 10 px/D their discs are 5.7, 2.7 and 3.8 px.
  constexpr double pixel = 4e-4;
  const Eye eye = Eye::with(Prescription{0.0, 0.0, 0.0, 0.0}, 20.0 * pixel);
  const KernelBank bank(ray_kernels(eye, 0.7, pixel, {8, true}), {1.0});
  EXPECT_LT(bank.detail_share(0, 0), 0.8f);
  EXPECT_NEAR(bank.detail_share(0, 1), 1.0f, 0.02f);
  EXPECT_NEAR(bank.detail_share(0, 2), 1.0f, 0.02f);
}

}  // namespace
}  // namespace sturm
