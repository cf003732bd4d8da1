#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "wavefront/layers/outshone_colours.h"

namespace sturm {
namespace {

constexpr int wide = 24, high = 20;

template <class Value>
LayeredPicture surface_of(const Value& value) {
  LayeredPicture picture;
  picture.radiance = Image(wide, high, 3);
  picture.vergence_D.assign(wide * high, 1.0);
  picture.jump_D = 0.2;
  for (int y = 0; y < high; ++y)
    for (int x = 0; x < wide; ++x) std::fill_n(picture.radiance.at(x, y), 3, static_cast<float>(value(x, y)));
  return picture;
}

/// What is guessed in the pixels from (left, top) on, `columns` by `rows` of them, row by row; they say 9.
std::vector<float> guessed(LayeredPicture picture, int left, int top, int columns, int rows) {
  std::vector<HiddenPixel> outshone;
  for (int y = top; y < top + rows; ++y)
    for (int x = left; x < left + columns; ++x) {
      std::fill_n(picture.radiance.at(x, y), 3, 1e4f);
      outshone.push_back({x, y, 1.0, 1.0f, {9.0f, 9.0f, 9.0f}});
    }
  guess_outshone(picture, outshone);
  std::vector<float> values;
  for (const HiddenPixel& pixel : outshone) values.push_back(pixel.rgb[1]);
  return values;
}

template <class Value>
void expect_as_was(const Value& value, int left, int top, int columns, int rows, double tolerance) {
  const std::vector<float> values = guessed(surface_of(value), left, top, columns, rows);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      EXPECT_NEAR(values[static_cast<std::size_t>(y * columns + x)], value(left + x, top + y), tolerance)
          << x << " " << y;
}

TEST(OutshoneColours, OfACubicAreItself) {
  // Steps on both sides of the lamps that are alike, and so count.
  const auto cubic = [](int x, int y) {
    const double u = (x - 11.5) / 12.0, v = (y - 9.5) / 10.0;
    return 3.0 + u * u * u - u * u + 2.0 * u + 0.5 * v * v * v + v * v - 1.5 * v;
  };
  expect_as_was(cubic, 10, 8, 1, 1, 2e-6);  // rounding of some values of 3
  expect_as_was(cubic, 9, 7, 3, 2, 2e-6);
}

TEST(OutshoneColours, AreThoseOfTheStripeThatALampLiesOn) {
  // Stripes of three pixels: those along them agree, those across do not. 1/256 of both brightnesses counts as equal,
  // so across them a weight of (1.8/256/0.8)² is left.
  for (const int first : {8, 9, 10, 11}) {
    expect_as_was([](int x, int) { return x / 3 % 2 == 0 ? 0.9 : 0.1; }, first, 8, 2, 2, 1e-4);
    expect_as_was([](int, int y) { return y / 3 % 2 == 0 ? 0.9 : 0.1; }, 8, first, 2, 2, 1e-4);
  }
}

TEST(OutshoneColours, BesideAStepDoNotOvershoot) {
  // The second pixel on the right belongs to another plateau. A cubic through all four would say 0.37.
  const auto step = [](int x, int) { return x < 12 ? 0.5 : 1.3; };
  const std::vector<float> values = guessed(surface_of(step), 10, 0, 1, high);  // nothing above nor below tells it
  for (const float value : values) EXPECT_EQ(value, 0.5f);
}

TEST(OutshoneColours, ComeFromTheSameSurfaceAlone) {
  // Twice as bright with each column, up to another surface, black.
  LayeredPicture picture = surface_of([](int x, int) { return x < 12 ? std::exp2(x) : 0.0; });
  for (int y = 0; y < high; ++y)
    for (int x = 12; x < wide; ++x) picture.vergence_D[static_cast<std::size_t>(y * wide + x)] = 3.0;
  EXPECT_EQ(guessed(picture, 11, 8, 1, 1), std::vector<float>{2048.0f});           // by the pixels above and below
  EXPECT_EQ(guessed(picture, 0, 0, 12, 1), std::vector<float>(12, 9.0f));          // between none
  EXPECT_EQ(guessed(picture, 10, 0, 1, high), std::vector<float>(high, 1280.0f));  // by 512 and 2048, but no 0
}

TEST(OutshoneColours, AreNotThoseOfOtherLamps) {
  LayeredPicture picture = surface_of([](int x, int) { return std::exp2(x); });
  std::vector<HiddenPixel> outshone;
  for (int y = 0; y < high; ++y)
    for (const int x : {10, 12}) {
      std::fill_n(picture.radiance.at(x, y), 3, 1e6f);
      outshone.push_back({x, y, 1.0, 1.0f, {}});
    }
  guess_outshone(picture, outshone);
  EXPECT_EQ(outshone[0].rgb[0], 1280.0f);  // (512 + 2048)/2: the second on the right is a lamp
  EXPECT_EQ(outshone[1].rgb[0], 5120.0f);  // (2048 + 8192)/2: the second on the left is one
}

TEST(OutshoneColours, AreNeverNegative) {
  const auto peak = [](int x, int y) { return std::max(std::abs(x - 10), std::abs(y - 8)) == 1 ? 0.0 : 1.0; };
  EXPECT_EQ(guessed(surface_of(peak), 10, 8, 1, 1), std::vector<float>{0.0f});
}

TEST(OutshoneColours, OfBlackAreBlack) {
  EXPECT_EQ(guessed(surface_of([](int, int) { return 0.0; }), 10, 8, 1, 1), std::vector<float>{0.0f});
}

}  // namespace
}  // namespace sturm
