#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "io/io_testing.h"
#include "io/specs/sag_grid.h"
#include "lensmodel/progressive_surface.h"
#include "lensmodel/sphere_surface.h"
#include "lensmodel/surface_power.h"
#include "support/source_folder.h"
#include "support/units.h"

namespace sturm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::mm;

std::string row(double x_mm, double y_mm, double z_mm, const char* format = "%.9f,%.9f,%.9f\n") {
  char text[96];
  std::snprintf(text, sizeof text, format, x_mm, y_mm, z_mm);
  return text;
}

double sphere_mm(double x_mm, double y_mm) {
  return SphereSurface{10.0}.sag(x_mm * mm, y_mm * mm)->value / mm;
}

/// A sphere of 100 mm on a regular grid over ±20 mm, 2 mm apart.
std::string regular() {
  std::string text = "# made by a test\n\nx_mm, y_mm, z_mm\r\n";
  for (int j = -10; j <= 10; ++j)
    for (int i = -10; i <= 10; ++i) text += row(2.0 * i, 2.0 * j, 3.0 + sphere_mm(2.0 * i, 2.0 * j));
  return text;
}

/// The same sphere on points of a sunflower within 20 mm.
std::string sunflower(int count, double without_mm = 0.0) {
  std::string text = "x_mm,y_mm,z_mm\n";
  for (int i = 0; i < count; ++i) {
    const double r = 20.0 * std::sqrt((i + 0.5) / count), x = r * std::cos(2.399963229728653 * i),
                 y = r * std::sin(2.399963229728653 * i);
    if (std::hypot(x - 8.0, y - 3.0) >= without_mm) text += row(x, y, sphere_mm(x, y));
  }
  return text;
}

class SagGridFile : public ::testing::Test {
 protected:
  std::string file(const std::string& text) {
    write_text(folder_ / "front.csv", text);
    return (folder_ / "front.csv").string();
  }
  std::string error(const std::string& text, std::optional<double> knot_spacing = std::nullopt, double rim = 15 * mm) {
    const std::string name = file(text);
    return input_error([&] { read_sag_grid(name, knot_spacing, rim); });
  }
  TemporaryFolder folder_;
};

TEST_F(SagGridFile, ARegularGridIsInterpolated) {
  const SagGrid grid = read_sag_grid(file(regular()), std::nullopt, 15 * mm);
  EXPECT_EQ(grid.points, 441u);
  EXPECT_EQ(grid.surface.grid().cells_x, 20);
  EXPECT_LT(grid.residual.max, 1e-16);                         // knots are points
  EXPECT_NEAR(grid.surface.sag(0.0, 0.0)->value, 0.0, 1e-17);  // 3 mm were taken off
  EXPECT_NEAR(grid.surface.sag(9 * mm, -5 * mm)->value / mm, sphere_mm(9, -5),
              1e-6);  // h⁴/384 · 2 · 3c³ = 2.5e-10 m times 2
  EXPECT_NEAR(surface_power(*grid.surface.sag(9 * mm, -5 * mm), 1.5).mean_D, 5.0,
              2e-3);  // h²/12 · 3c³ (n − 1) and more off the vertex
}

TEST_F(SagGridFile, OtherPointsAreFittedAndTheResidualIsSaid) {
  const SagGrid grid = read_sag_grid(file(sunflower(800)), std::nullopt, 15 * mm);
  EXPECT_NEAR(grid.surface.grid().spacing.x(), 1.5 * 40 * mm / std::sqrt(800.0), 0.1 * mm);
  EXPECT_GT(grid.residual.max, 1e-13);  // the digits that were printed
  EXPECT_LT(grid.residual.max, 1e-8);
  EXPECT_LE(grid.residual.rms, grid.residual.max);
  EXPECT_NEAR(surface_power(*grid.surface.sag(9 * mm, -5 * mm), 1.5).mean_D, 5.0, 5e-3);
  const SagGrid coarse = read_sag_grid(file(sunflower(800)), 8 * mm, 15 * mm);
  EXPECT_NEAR(coarse.surface.grid().spacing.x(), 8 * mm, 0.1 * mm);
  EXPECT_GT(coarse.residual.rms, grid.residual.rms);
}

TEST_F(SagGridFile, ATableIsReadAsPeopleWriteIt) {
  const auto with = [](const char* heading, const char* format, char point) {
    std::string text = heading;
    for (int j = -10; j <= 10; ++j)
      for (int i = -10; i <= 10; ++i) {
        std::string line = row(2.0 * i, 2.0 * j, sphere_mm(2.0 * i, 2.0 * j), format);
        for (char& c : line)
          if (c == '.') c = point;
        text += line;
      }
    return text;
  };
  const double sag = read_sag_grid(file(regular()), std::nullopt, 15 * mm).surface.sag(9 * mm, -5 * mm)->value;
  for (const std::string& text :
       {with("X (mm);Y (mm);Sag (mm)\r\n", "%.9f;%.9f;%.9f\r\n", ','), with("x\ty\tz\n", "%+.9f\t%+.9f\t%+.9f\n", ','),
        with("x y z\n", "  %.9f   %.9f  %.9f\n", '.'), with("x_mm,y_mm,SAG_mm\r", "\"%.9f\",\"%.9f\",\"%.9f\"\r", ',')})
    EXPECT_NEAR(read_sag_grid(file(text), std::nullopt, 15 * mm).surface.sag(9 * mm, -5 * mm)->value, sag, 1e-12);
  EXPECT_THAT(error("x_mm,y_mm,z_mm\n0,0,1,5\n"), AllOf(HasSubstr("line 2"), HasSubstr("at most 3 fields")));
  EXPECT_THAT(error("x_m,y_m,z_m\n0,0,0\n"), HasSubstr("x_mm, y_mm and z_mm"));  // another unit is not misread
}

TEST_F(SagGridFile, WhatIsWrongIsNamedWithItsLine) {
  EXPECT_THAT(error("a,b,c\n1,2,3\n"),
              AllOf(HasSubstr("front.csv"), HasSubstr("line 1"), HasSubstr("x_mm, y_mm and z_mm")));
  EXPECT_THAT(error("x_mm,y_mm,z_mm\n0,0,0\n1,2,nan\n"),
              AllOf(HasSubstr("line 3"), HasSubstr("\"nan\""), HasSubstr("a finite number [mm]")));
  EXPECT_THAT(error("x_mm,y_mm,z_mm\n0,0,0\n# note\n1,2\n"),
              AllOf(HasSubstr("line 4"), HasSubstr("2 values"), HasSubstr("at least 3")));
  EXPECT_THAT(error("x_mm,y_mm,z_mm\n0,0,1e999\n"), HasSubstr("line 2"));
  EXPECT_THAT(error("x_mm,y_mm,z_mm\n0,0,0\n"), AllOf(HasSubstr("1 points"), HasSubstr("at least 16")));
  EXPECT_THAT(error(regular() + "4,-6,1\n"),
              AllOf(HasSubstr("line 445"), HasSubstr("(4, -6) mm again"), HasSubstr("line ")));
  EXPECT_THAT(error(sunflower(800, 4.0)), AllOf(HasSubstr("a gap: no point near ("), HasSubstr("knot_spacing_mm")));
  EXPECT_THAT(error(sunflower(800), 0.1 * mm),
              AllOf(HasSubstr("a knot spacing of 0.1 mm"), HasSubstr("at least 0.15")));
  EXPECT_THAT(input_error([&] { read_sag_grid(folder_.path(), std::nullopt, 15 * mm); }),
              HasSubstr("a file that cannot be read"));
  std::string line = "x_mm,y_mm,z_mm\n", aside = line;
  for (int i = 0; i < 20; ++i) line += row(i, 3.0, 0.0);
  for (int i = 0; i < 49; ++i) aside += row(10.0 + i / 7, i % 7 - 3.0, 0.0);
  EXPECT_THAT(error(line), HasSubstr("points on one line"));
  EXPECT_THAT(error(aside), HasSubstr("points about the lens's axis at (0, 0)"));
}

ProgressiveSurfaceDesign reference_design() {
  ProgressiveSurfaceDesign design;
  design.refractive_index = 1.498;
  return design;
}

struct ReferencePoint {
  double x, y, mean_D;
};
std::vector<ReferencePoint> reference_points() {
  std::ifstream in(std::string(STURM_SOURCE_DIR) + "/tests/reference/pal_circular_section_reference.csv");
  std::vector<ReferencePoint> points;
  for (std::string line; std::getline(in, line);) {
    double v[5];
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf", v, v + 1, v + 2, v + 3, v + 4) == 5)
      points.push_back({v[0] * mm, v[1] * mm, v[3]});
  }
  return points;
}

TEST_F(SagGridFile, TheProgressiveReferenceComesBackFromItsOwnPoints) {
  // 91 points, 2 to 8 mm apart: enough for the far and near zone, not for the corridor's curvature.
  const SagGrid grid = read_sag_grid(
      std::string(STURM_SOURCE_DIR) + "/tests/reference/pal_circular_section_reference.csv", 3 * mm, 20 * mm);
  EXPECT_EQ(grid.points, 91u);
  double worst = 0.0;
  int count = 0;
  for (const ReferencePoint& p : reference_points()) {
    if (p.y > 5.1 * mm || p.x < -17 * mm || p.x > 23 * mm) continue;
    ++count;
    worst = std::fmax(worst, std::abs(surface_power(*grid.surface.sag(p.x, p.y), 1.498).mean_D - p.mean_D));
  }
  EXPECT_EQ(count, 44);
  // Knots 3 mm apart in a corridor of 14 mm. Measured: 0.372 D; residual 0.25 um (rms), 1.32 um (max).
  EXPECT_LT(worst, 0.38);
  EXPECT_LT(grid.residual.rms, 0.3e-6);
  EXPECT_LT(grid.residual.max, 1.4e-6);
}

TEST_F(SagGridFile, TheProgressiveReferenceComesBackFromAnExportOfHalfAMillimetre) {
  const ProgressiveSurface surface(reference_design());
  std::string text = "# 0.5 mm, printed to a nanometre\nx_mm,y_mm,sag_mm\n";
  for (int i = -52; i <= 52; ++i)  // the reference's x runs down, its y sideways
    for (int j = -44; j <= 44; ++j)
      text += row(0.5 * i, 0.5 * j, surface.sag(0.5 * mm * j, -0.5 * mm * i)->value / mm, "%.1f,%.1f,%.6f\n");
  const SagGrid grid = read_sag_grid(file(text), std::nullopt, 20 * mm);
  double worst = 0.0, near = 0.0;
  for (const ReferencePoint& p : reference_points()) {
    const double error = std::abs(surface_power(*grid.surface.sag(p.x, p.y), 1.498).mean_D - p.mean_D);
    worst = std::fmax(worst, error);
    if (p.y < 6 * mm) near = std::fmax(near, error);
  }
  // h²/12 of the power's second derivative. Measured: 0.0055 D within 5 mm of the umbilic; 0.061 D at 20 mm, where the
  // cylinder is 20 D.
  EXPECT_LT(near, 0.006);
  EXPECT_LT(worst, 0.065);
}

}  // namespace
}  // namespace sturm
