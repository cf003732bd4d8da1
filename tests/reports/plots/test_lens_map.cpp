#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/plots/contour_lines.h"
#include "reports/plots/lens_map.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(ContourLines, OfAPlaneIsOneStraightLine) {
  Eigen::MatrixXd plane(5, 7);
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 7; ++column) plane(row, column) = 2.0 * column + row;
  double length = 0.0;
  for (const ContourPiece& piece : contour_lines(plane, 5.5)) {
    for (const Eigen::Vector2d& end : piece) EXPECT_NEAR(2.0 * end.x() + end.y(), 5.5, 1e-14);
    length += (piece[1] - piece[0]).norm();
  }
  EXPECT_NEAR(length, std::hypot(4.0, 2.0), 1e-14);  // from row 0 to row 4, half as far along the columns
}

TEST(ContourLines, OfACircleHasItsLength) {
  constexpr int n = 201;
  Eigen::MatrixXd cone(n, n);
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column) cone(row, column) = std::hypot(row - 100.3, column - 99.6);
  double length = 0.0;
  for (const ContourPiece& piece : contour_lines(cone, 80.0)) length += (piece[1] - piece[0]).norm();
  EXPECT_NEAR(length / (2.0 * 3.14159265358979 * 80.0), 1.0,
              1e-4);  // chords of length 1 on a radius of 80: 1/(24·80²) = 7e-6, and linear sides
}

TEST(ContourLines, StopWhereThereAreNoValues) {
  Eigen::MatrixXd plane(2, 3);
  plane << 0, 0, std::numeric_limits<double>::quiet_NaN(), 1, 1, 1;
  EXPECT_EQ(contour_lines(plane, 0.5).size(), 1u);
  EXPECT_TRUE(contour_lines(plane, 2.0).empty());
}

TEST(ContourLines, ASaddleIsCutByItsMean) {
  Eigen::MatrixXd saddle(2, 2);
  saddle << 1, -1, -1, 1.5;  // the middle is above 0: the low corners (1, 0) and (0, 1) are cut off
  const auto pieces = contour_lines(saddle, 0.0);
  ASSERT_EQ(pieces.size(), 2u);
  for (const ContourPiece& piece : pieces) {
    const Eigen::Vector2d middle = 0.5 * (piece[0] + piece[1]);
    EXPECT_GT(std::abs(middle.x() - middle.y()), 0.4);  // off the diagonal from high to high
  }
}

TEST(ContourLines, PiecesOfACircleAreOneClosedLine) {
  constexpr int n = 61;
  Eigen::MatrixXd cone(n, n);
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column) cone(row, column) = std::hypot(row - 30.3, column - 29.6);
  const auto pieces = contour_lines(cone, 20.0);
  const auto lines = joined(pieces);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].size(), pieces.size() + 1);
  EXPECT_LT((lines[0].front() - lines[0].back()).norm(), 1e-9);
  for (std::size_t i = 1; i < lines[0].size(); ++i) EXPECT_LT((lines[0][i] - lines[0][i - 1]).norm(), 1.5);
}

TEST(ContourLines, APlaneHasOneOpenLine) {
  Eigen::MatrixXd plane(4, 9);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 9; ++column) plane(row, column) = column;
  const auto lines = joined(contour_lines(plane, 2.5));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].size(), 4u);
  EXPECT_NEAR((lines[0].front() - lines[0].back()).norm(), 3.0, 1e-12);
}

LensMap map() {
  LensMap m;
  m.title = "mean power\\nof a test";
  m.rim_radius_mm = 25.0;
  m.fitting_cross_mm << 3.0, -2.0;
  m.values = Eigen::MatrixXd::Constant(21, 21, std::numeric_limits<double>::quiet_NaN());
  for (int row = 5; row < 16; ++row)
    for (int column = 5; column < 16; ++column) m.values(row, column) = 0.1 * (row - 10);  // grows upwards
  return m;
}

TEST(LensMap, ScriptHasPlacesScaleRimAndCross) {
  const LensMap m = map();
  const std::string script = lens_map_script({&m, 1});
  EXPECT_THAT(script, HasSubstr("\n-12.5 -12.5 -0.5\n"));  // row 5, column 5: the lowest and leftmost value
  EXPECT_THAT(script, HasSubstr("\n12.5 12.5 0.5\n"));
  EXPECT_THAT(script, HasSubstr("\n25 25 NaN\n"));
  EXPECT_THAT(script, HasSubstr("set cbrange [-1:1]"));
  EXPECT_THAT(script, HasSubstr("(25*cos($1)):(25*sin($1))"));
  EXPECT_THAT(script, HasSubstr("(3):(-2)"));
  EXPECT_THAT(script, Not(HasSubstr("$limit")));
}

TEST(LensMap, MapsOfOneKindShareTheirScale) {
  LensMap maps[] = {map(), map(), map()};
  maps[1].values *= 5.0;
  maps[2].signed_scale = false;
  const std::string script = lens_map_script(maps);
  const std::size_t first = script.find("set cbrange [-3:3]");
  EXPECT_NE(first, std::string::npos);
  EXPECT_NE(script.find("set cbrange [-3:3]", first + 1), std::string::npos);
  EXPECT_THAT(script, HasSubstr("set cbrange [0:1]"));
}

TEST(LensMap, AGivenRangeIsThatOfAllMaps) {
  LensMap maps[] = {map(), map()};
  maps[1].signed_scale = false;
  const std::string script = lens_map_script(maps, {1, 2.5});
  EXPECT_THAT(script, HasSubstr("set cbrange [-2.5:2.5]"));
  EXPECT_THAT(script, HasSubstr("set cbrange [0:2.5]"));
}

TEST(LensMap, TitlesAreNoCommands) {
  LensMap m = map();
  m.title = "a_b \"c\"\\nd";
  EXPECT_THAT(lens_map_script({&m, 1}), HasSubstr("set title \"a\\\\_b \\\"c\\\"\\nd\""));
}

TEST(LensMap, TheTableHasEveryPlaceWithAValue) {
  const LensMap m = map();
  const std::string csv = lens_map_plot({&m, 1}).csv;
  EXPECT_TRUE(csv.starts_with("map,unit,x_mm,y_mm,value\r\n\"mean power, of a test\",D,-12.5,-12.5,-0.5\r\n"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 11 * 11);
}

TEST(LensMap, Pictures) {
  LensMap m = map();
  m.limit_values = m.values;
  m.limit = 0.3;
  const std::string svg = lens_map_svg(m, "lens").markup(), file = lens_map_svg_file({&m, 1}),
                    png = lens_map_png_file({&m, 1});
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(svg.starts_with("<svg class=\"plot\""));
  EXPECT_TRUE(has(svg, "mean power, of a test"));
  EXPECT_FALSE(has(svg, "xmlns"));
  EXPECT_TRUE(has(svg, "href='data:image/png;base64,"));  // the picture inside keeps its address
  EXPECT_FALSE(has(svg, "<title>gnuplot"));               // no tooltips with gnuplot's own names
  EXPECT_TRUE(file.starts_with("<?xml"));
  EXPECT_TRUE(has(file, "xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_EQ(png.substr(1, 3), "PNG");
}

}  // namespace
}  // namespace sturm
