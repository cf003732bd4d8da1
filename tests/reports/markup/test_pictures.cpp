#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <regex>

#include "reports/markup/false_colour.h"
#include "reports/markup/pictures.h"

namespace sturm {
namespace {

double lightness(const DisplayColour& c) {
  return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}

TEST(FalseColour, SequentialMapGetsLighterAllTheWay) {
  for (int i = 0; i < 255; ++i)
    EXPECT_LT(lightness(sequential_colour(i / 256.0)), lightness(sequential_colour((i + 4) / 256.0))) << i;
  EXPECT_EQ(sequential_colour(-1.0), sequential_colour(0.0));
  EXPECT_EQ(sequential_colour(2.0), sequential_colour(1.0));
}

TEST(FalseColour, SequentialMapIsInferno) {  // entries 0, 65 and 255 of matplotlib's table, which are among those kept
  const DisplayColour low = sequential_colour(0.0), quarter = sequential_colour(65.0 / 255.0),
                      high = sequential_colour(1.0);
  EXPECT_THAT(low, ::testing::ElementsAre(0.0f, 0.0f, 4.0f / 255));
  EXPECT_THAT(quarter, ::testing::ElementsAre(0x59 / 255.0f, 0x10 / 255.0f, 0x6e / 255.0f));
  EXPECT_THAT(high, ::testing::ElementsAre(0xfc / 255.0f, 1.0f, 0xa4 / 255.0f));
}

TEST(FalseColour, DivergingMapIsBlueForNegativeAndRedForPositive) {
  const DisplayColour minus = diverging_colour(-0.6), zero = diverging_colour(0.0), plus = diverging_colour(0.6);
  EXPECT_GT(minus[2], minus[0] + 0.2f);
  EXPECT_GT(plus[0], plus[2] + 0.2f);
  EXPECT_THAT(zero, ::testing::Each(0xf7 / 255.0f));
}

TEST(FalseColour, LogarithmicScaleCountsDecadesBelowThePeak) {
  const SequentialScale scale{.peak = 50.0, .decades = 2.0};
  EXPECT_DOUBLE_EQ(position_on(scale, 50.0), 1.0);
  EXPECT_DOUBLE_EQ(position_on(scale, 5.0), 0.5);
  EXPECT_DOUBLE_EQ(position_on(scale, 0.4), 0.0);
  EXPECT_DOUBLE_EQ(position_on(scale, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(position_on(scale, -1.0), 0.0);
  EXPECT_DOUBLE_EQ(position_on({.peak = 50.0}, 5.0), 0.1);
}

TEST(FalseColour, ValuesThatAreNotFiniteStandOut) {
  Image values(2, 1, 1);
  values.pixels = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
  for (const Image& image : {sequential_false_colour(values, {}), diverging_false_colour(values, 1.0)}) {
    EXPECT_THAT(image.pixels, ::testing::ElementsAre(0, 1, 0, 0, 1, 0));
  }
  EXPECT_THROW(diverging_false_colour(Image(1, 1, 3), 1.0), std::invalid_argument);
}

/// Where SVG puts the right end of the major axis: rotate(φ) turns from x towards y, which points down.
std::pair<double, double> end_of_major_axis(const std::string& svg) {
  std::smatch radius, angle;
  std::regex_search(svg, radius, std::regex("rx=\"([^\"]+)\""));
  const bool turned = std::regex_search(svg, angle, std::regex(R"(rotate\(([^ ]+) )"));
  const double phi = turned ? std::stod(angle[1]) * std::numbers::pi / 180.0 : 0.0, r = std::stod(radius[1]);
  return {r * std::cos(phi), r * std::sin(phi)};
}

TEST(EllipseDrawing, PlusThirtyDegreesRisesToTheRight) {
  const auto [right, down] = end_of_major_axis(svg_ellipse({10.0, 4.0, 30.0}, 2.0, 48.0, 48.0, "predicted").markup());
  EXPECT_NEAR(right, 20.0 * 0.8660254, 1e-5);  // six digits are written
  EXPECT_NEAR(down, -10.0, 1e-5);              // up on the screen
}

TEST(EllipseDrawing, MinusThirtyDegreesFallsToTheRight) {
  const auto [right, down] = end_of_major_axis(svg_ellipse({10.0, 4.0, -30.0}, 2.0, 48.0, 48.0, "predicted").markup());
  EXPECT_GT(right, 0.0);
  EXPECT_NEAR(down, 10.0, 1e-5);
}

TEST(EllipseDrawing, CircleIsNotTurnedAndAFocalLineIsStillDrawn) {
  EXPECT_THAT(svg_ellipse({5.0, 5.0, std::nullopt}, 1.0, 48.0, 48.0, "measured").markup(),
              ::testing::Not(::testing::HasSubstr("rotate")));
  EXPECT_THAT(svg_ellipse({5.0, 0.0, 90.0}, 1.0, 48.0, 48.0, "measured").markup(), ::testing::HasSubstr("ry=\"0.01\""));
}

TEST(ReportPictures, Base64OfRfc4648) {  // its section 10
  const auto encode = [](const std::string& text) { return base64({text.begin(), text.end()}); };
  EXPECT_EQ(encode(""), "");
  EXPECT_EQ(encode("f"), "Zg==");
  EXPECT_EQ(encode("fo"), "Zm8=");
  EXPECT_EQ(encode("foo"), "Zm9v");
  EXPECT_EQ(encode("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64({0xff, 0xfe, 0xfd}), "//79");
}

TEST(ReportPictures, RoundLengths) {
  EXPECT_DOUBLE_EQ(round_length_below(7.3), 5.0);
  EXPECT_DOUBLE_EQ(round_length_below(0.21), 0.2);
  EXPECT_DOUBLE_EQ(round_length_below(1.0), 1.0);
  EXPECT_DOUBLE_EQ(round_length_above(0.021), 0.05);
  EXPECT_DOUBLE_EQ(round_length_above(6.0), 10.0);
}

TEST(ReportPictures, ShrinkingTakesMeansAlsoAtTheEdge) {
  Image image(3, 2, 1);
  image.pixels = {1, 3, 10, 5, 7, 20};
  const Image half = shrunk(image, 2);
  ASSERT_EQ(half.width, 2);
  ASSERT_EQ(half.height, 1);
  EXPECT_THAT(half.pixels, ::testing::ElementsAre(4.0f, 15.0f));
}

TEST(ReportPictures, ShrinkingTakesEachChannelByItself) {
  // 5 × 4 pixels in blocks of 3: two columns and one row are left over at the edge.
  Image image(5, 4, 3);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x) image.at(x, y)[0] = x * x, image.at(x, y)[1] = 10 * y * y, image.at(x, y)[2] = x * y;
  const Image small = shrunk(image, 3);
  ASSERT_EQ(small.width, 2);
  ASSERT_EQ(small.height, 2);
  ASSERT_EQ(small.channels, 3);
  const float expected[] = {5.0f / 3, 50.0f / 3, 1.0f, 12.5f, 50.0f / 3, 3.5f,  //
                            5.0f / 3, 90.0f,     3.0f, 12.5f, 90.0f,     10.5f};
  EXPECT_THAT(small.pixels, ::testing::Pointwise(testing::FloatEq(), expected));
  EXPECT_EQ(shrunk(image, 9).pixels.size(), 3u);
}

TEST(ReportPictures, LumaIsRec709) {
  Image image(1, 1, 3);
  image.pixels = {1.0f, 0.5f, 0.25f};
  EXPECT_FLOAT_EQ(luma_image(image).pixels[0], 0.2126f + 0.3576f + 0.01805f);
}

}  // namespace
}  // namespace sturm
