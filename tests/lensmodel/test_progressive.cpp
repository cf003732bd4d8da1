#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "lensmodel/gaze.h"
#include "lensmodel/lens_material.h"
#include "lensmodel/progressive.h"
#include "support/source_folder.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::mm;

ProgressiveDesign design() {
  ProgressiveDesign d;
  d.lens.base_curve_D = 5.5;
  d.lens.refractive_index = 1.6;
  d.lens.diameter_m = 60 * mm;
  d.addition_D = 3.0;
  d.near_shift_m = -2.5 * mm;
  d.zone_width_m = 10 * mm;
  return d;
}

TEST(Progressive, TheSplineHoldsThePowersAndSaysHowWell) {
  const ProgressiveLens made = progressive_lens({-1.0}, design());
  EXPECT_LE(made.power_residual.mean_D, 1e-3);
  EXPECT_LE(made.power_residual.cylinder_D, 1e-3);
  EXPECT_GT(made.power_residual.mean_D, 1e-5);
  EXPECT_LE(made.knot_spacing_m, 0.125 * mm);
  // Places that were not sampled: on circles about the vertex. Within the cells' middles and corners the error is
  // greatest.
  const ProgressiveSurface exact = progressive_front({-1.0}, design());
  for (int i = 0; i < 5000; ++i) {
    const double r = 30 * mm * std::sqrt(i / 5000.0), angle = 2.399963229728653 * i, x = r * std::cos(angle),
                 y = r * std::sin(angle);
    const SurfacePower a = surface_power(*exact.sag(x, y), 1.6), b = surface_power(*sag(made.lens.front, x, y), 1.6);
    EXPECT_NEAR(a.mean_D, b.mean_D, 1.05 * made.power_residual.mean_D);  // places up to 3 knots apart were sampled
    EXPECT_NEAR(a.cylinder_D, b.cylinder_D, 1.05 * made.power_residual.cylinder_D);
  }
}

TEST(Progressive, ACoarserSplineIsWorseByTheSquareOfItsSpacing) {
  ProgressiveDesign coarse = design();
  coarse.knot_spacing_m = 0.25 * mm;
  const double fine = progressive_lens({-1.0}, design()).power_residual.mean_D;
  EXPECT_NEAR(std::log2(progressive_lens({-1.0}, coarse).power_residual.mean_D / fine), 2.0, 0.1);
}

TEST(Progressive, TheFarZoneIsTheSingleVisionLens) {
  const Prescription rx{-2.0, -1.5, 30.0};
  const ProgressiveLens made = progressive_lens(rx, design());
  const Spectacles single = single_vision(rx, design().lens);
  // Through the distance reference point, 8 mm above the fitting cross, and to its sides.
  for (const double azimuth : {-25.0, -5.0, 0.0, 15.0}) {
    const double a = azimuth * std::numbers::pi / 180.0, e = 17.0 * std::numbers::pi / 180.0;
    const Eigen::Vector3d gaze = gaze_direction(a, e), center(0.0, 0.0, 13.5 * mm);
    const LensPath got = trace(made.lens, {center, gaze}), expected = trace(single, {center, gaze});
    ASSERT_EQ(got.status, LensStatus::ok);
    EXPECT_LT((got.exit.origin - expected.exit.origin).norm(), 1e-10);  // O(h⁴) of the spline
    EXPECT_LT((got.exit.direction - expected.exit.direction).norm(), 1e-7);
  }
}

/// Power along the gaze from two parallel rays, up to the effects of obliquity: outside they converge if it is
/// positive.
double vertical_power_D(const Spectacles& lens, double elevation_deg) {
  const double e = elevation_deg * std::numbers::pi / 180.0, h = 1e-4;
  const Eigen::Vector3d center(0.0, 0.0, 13.5 * mm), gaze = gaze_direction(0.0, e), up(0.0, std::cos(e), std::sin(e));
  const LensPath low = trace(lens, {center - h * up, gaze}), high = trace(lens, {center + h * up, gaze});
  return (high.exit.direction - low.exit.direction).dot(up) / (-2 * h);
}

TEST(Progressive, LookingDownThereIsMorePower) {
  const Spectacles lens = progressive_lens({-1.0}, design()).lens;
  const double up = vertical_power_D(lens, 15.0), down = vertical_power_D(lens, -37.0);
  EXPECT_NEAR(up, -1.0, 0.2);  // of the order of the oblique error of a lens of −1 D
  EXPECT_NEAR(down - up, 3.0, 0.9);
}

TEST(Progressive, TheNearZoneLiesWhereItsShiftSays) {
  const Spectacles lens = progressive_lens({-1.0}, design()).lens;  // shifted to the wearer's left
  EXPECT_GT(sag(lens.front, -9 * mm, -13 * mm)->value, sag(lens.front, 9 * mm, -13 * mm)->value + 1e-5);
}

TEST(Progressive, WhatCannotBeMade) {
  ProgressiveDesign steep = design();
  steep.lens.base_curve_D = 30.0;  // a radius of 20 mm does not reach a rim of 30 mm
  EXPECT_THROW(progressive_lens({-1.0}, steep), std::domain_error);
}

TEST(BaseCurve, VogelsRule) {
  EXPECT_EQ(usual_base_curve_D({2.0}), 8.0);
  EXPECT_EQ(usual_base_curve_D({-4.0, -2.0, 30.0}), 3.5);
  EXPECT_EQ(usual_base_curve_D({0.0}), 6.0);
  EXPECT_EQ(usual_base_curve_D({-15.0}), 0.0);  // never hollow
  const Spectacles lens = single_vision({-2.0}, {});
  EXPECT_NEAR(std::get<SphereSurface>(lens.front).curvature, 5.0 / 0.5, 1e-14);
}

TEST(BaseCurve, IsWithinADioptreAndAHalfOfTheFormsWithoutObliqueAstigmatism) {
  std::ifstream in(std::string(STURM_SOURCE_DIR) + "/tests/reference/tscherning_point_focal.csv");
  int rows = 0;
  double worst = 0.0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream text(line);
    std::string material, field;
    std::getline(text, material, ',');
    double values[4];
    if (material != "CR-39") continue;
    for (double& value : values) value = (std::getline(text, field, ','), std::stod(field));
    const double power = values[1], ostwalt = values[3];
    if (power < -10.0) continue;
    ++rows;
    worst = std::fmax(worst, std::abs(usual_base_curve_D({power}) - ostwalt));
  }
  EXPECT_EQ(rows, 13);
  EXPECT_LT(worst, 1.45);
  EXPECT_GT(worst, 1.40);  // −2 D: 5 and 6.44 D
}

TEST(LensMaterial, IsFoundByName) {
  EXPECT_EQ(lens_material("CR-39")->refractive_index, 1.498);
  EXPECT_EQ(lens_material("polycarbonate")->abbe_number, 30.0);
  EXPECT_FALSE(lens_material("cr-39"));
  for (const LensMaterial& m : lens_materials()) {
    EXPECT_GT(m.refractive_index, 1.49);
    EXPECT_LT(m.refractive_index, 1.75);
    EXPECT_GE(m.abbe_number, 30.0);
    EXPECT_LE(m.abbe_number, 59.0);
  }
}

}  // namespace
}  // namespace sturm
