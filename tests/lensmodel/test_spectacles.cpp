#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <stdexcept>

#include "lensmodel/gaze.h"
#include "lensmodel/single_vision.h"
#include "support/fixed_rapidcheck_seed.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::degree;
using testing::mm;

LensPath chief_ray(const Spectacles& lens, double azimuth_deg, double elevation_deg) {
  const Eigen::Vector3d gaze = gaze_direction(azimuth_deg * degree, elevation_deg * degree);
  return trace(lens, {turned_pupil_center(gaze, 13.5 * mm), gaze});
}

Spectacles slab(double thickness_m, double index) {
  Spectacles lens;
  lens.center_thickness_m = thickness_m;
  lens.refractive_index = index;
  return lens;
}

TEST(Spectacles, APlaneSlabShiftsTheRayAndKeepsItsDirection) {
  // 30° into n = 1.5: sin φ' = 1/3, tan φ' = 1/√8. From the pupil's centre as if it did not turn: back point 12·tan 30°
  // to the right.
  const LensPath path = trace(slab(6 * mm, 1.5), {{0.0, 0.0, 0.0}, {0.5, 0.0, -0.86602540378443865}});
  ASSERT_EQ(path.status, LensStatus::ok);
  EXPECT_NEAR(path.back_point.x(), 6.9282032302755091 * mm, 1e-17);
  EXPECT_NEAR(path.inside_direction.x(), 1.0 / 3.0, 1e-16);
  EXPECT_NEAR(path.exit.origin.x(), (6.9282032302755091 + 6.0 * 0.35355339059327376) * mm, 1e-17);
  EXPECT_NEAR(path.exit.origin.z(), -18 * mm, 1e-17);
  EXPECT_NEAR(path.exit.direction.x(), 0.5, 1e-15);
}

TEST(Spectacles, AMinusLensBendsTheLineOfSightOutward) {
  const Spectacles minus = single_vision({-6.0}, {}), plus = single_vision({6.0}, {});
  const double right = gaze_direction(20 * degree, 0.0).x();
  EXPECT_GT(chief_ray(minus, 20, 0).exit.direction.x(), right + 0.02);
  EXPECT_LT(chief_ray(plus, 20, 0).exit.direction.x(), right - 0.02);
  EXPECT_LT(chief_ray(minus, 0, -20).exit.direction.y(), -right - 0.02);
}

TEST(Spectacles, AnObliqueCylinderBendsUpOrDown) {
  // Thin lens: slope −F p. Looking to the right through a minus cylinder, AXIS 30: power along (−1/2, −√3/2), so the
  // ray goes up as well; through AXIS 150 down; through 180 and 90 neither.
  const auto rise = [](double axis) {
    return chief_ray(single_vision({0.0, -4.0, axis}, {}), 20, 0).exit.direction.y();
  };
  EXPECT_GT(rise(30), 0.01);
  EXPECT_LT(rise(150), -0.01);
  EXPECT_NEAR(rise(30), -rise(150), 1e-15);
  EXPECT_NEAR(rise(180), 0.0, 1e-17);
  EXPECT_NEAR(rise(90), 0.0, 1e-17);
}

TEST(Spectacles, TheRimStopsTheRay) {
  Spectacles lens = single_vision({-2.0}, {});
  EXPECT_EQ(chief_ray(lens, 30, 0).status, LensStatus::ok);
  lens.diameter_m = 25 * mm;  // the ray meets the lens at about 25.5 tan 30° = 14.7 mm
  EXPECT_EQ(chief_ray(lens, 30, 0).status, LensStatus::missed_lens);
  EXPECT_EQ(chief_ray(lens, 20, 0).status, LensStatus::ok);
}

TEST(Spectacles, TotalReflectionInsideIsAStatus) {
  // A front that bends away steeply, R = −20 mm: 25° to the right the ray meets it at about 61°, the critical angle
  // is 41.8°.
  Spectacles lens = slab(2 * mm, 1.5);
  lens.front = SphereSurface{-50.0};
  EXPECT_EQ(chief_ray(lens, 25, 0).status, LensStatus::total_internal_reflection);
  EXPECT_EQ(chief_ray(lens, 5, 0).status, LensStatus::ok);
}

TEST(Spectacles, AnIndexOf1IsNoLens) {
  Spectacles lens = single_vision({-5.0, -2.0, 40.0}, {});
  lens.refractive_index = 1.0;
  const LensPath path = chief_ray(lens, 25, -15);
  ASSERT_EQ(path.status, LensStatus::ok);
  EXPECT_LT((path.exit.direction - gaze_direction(25 * degree, -15 * degree)).norm(), 1e-15);
}

TEST(SingleVision, TheDocumentedExample) {
  // −2.00 −1.50 × 30, front of 250 mm = 2 D, 2 mm of n = 1.5: back 124.833 along AXIS 30, 90.821 across, as the
  // formats' example prints.
  const Spectacles lens = single_vision({-2.0, -1.5, 30.0}, {2.0, 2 * mm, 1.5, 12 * mm, 70 * mm});
  const auto& torus = std::get<TorusSurface>(lens.back);
  EXPECT_NEAR(1.0 / std::get<SphereSurface>(lens.front).curvature, 250 * mm, 1e-15);
  EXPECT_NEAR(1.0 / torus.sweep_curvature(), 124.833 * mm, 5e-7);  // half a unit of the last printed place
  EXPECT_NEAR(1.0 / torus.generator_curvature(), 90.821 * mm, 5e-7);
  EXPECT_NEAR(std::abs(torus.sweep_direction().dot(Eigen::Vector2d(-0.86602540378443865, 0.5))), 1.0,
              1e-15);  // the wearer's 150°
}

RC_GTEST_PROP(SingleVision, BackVertexPowerIsThePrescription, ()) {
  const double sphere = *rc::gen::inRange(-80, 49) * 0.25, cylinder = *rc::gen::inRange(-24, 1) * 0.25,
               index = 1.5 + 0.01 * *rc::gen::inRange(0, 40);
  const SingleVisionDesign design{0.25 * *rc::gen::inRange(0, 40), 0.1 * mm * *rc::gen::inRange(5, 100), index};
  const Spectacles lens = single_vision({sphere, cylinder, 35.0}, design);
  // Independent of the maker's formula: a paraxial ray at unit height from infinity; power is −slope/height behind the
  // lens.
  const auto power = [&](double front_curvature, double back_curvature) {
    double height = 1.0, slope = -(index - 1.0) * front_curvature / index;
    height += design.center_thickness_m * slope;
    slope = index * slope + (index - 1.0) * back_curvature * height;
    return -slope / height;
  };
  const double front = std::get<SphereSurface>(lens.front).curvature;
  if (cylinder == 0.0) {
    RC_ASSERT(std::abs(power(front, std::get<SphereSurface>(lens.back).curvature) - sphere) <= 1e-12);
  } else {
    const auto& torus = std::get<TorusSurface>(lens.back);
    RC_ASSERT(std::abs(power(front, torus.sweep_curvature()) - sphere) <= 1e-12);
    RC_ASSERT(std::abs(power(front, torus.generator_curvature()) - sphere - cylinder) <= 1e-12);
  }
}

RC_GTEST_PROP(SingleVision, BothWaysOfWritingMakeTheSameLens, ()) {
  const Prescription rx{*rc::gen::inRange(-40, 41) * 0.25, *rc::gen::inRange(-20, 21) * 0.25,
                        1.0 * *rc::gen::inRange(0, 181)};
  const Spectacles a = single_vision(rx, {}), b = single_vision(transposed(rx), {});
  const double x = 0.1 * mm * *rc::gen::inRange(-150, 151), y = 0.1 * mm * *rc::gen::inRange(-150, 151);
  RC_ASSERT(std::abs(sag(a.back, x, y)->value - sag(b.back, x, y)->value) <= 1e-17);
}

TEST(SingleVision, WhatCannotBeMade) {
  EXPECT_THROW(single_vision({-2.0}, {4.0, 2 * mm, 1.0}), std::invalid_argument);
  EXPECT_THROW(single_vision({-2.0}, {50.0, 30 * mm, 1.5}), std::domain_error);  // 1.5/50 m = 30 mm
}

}  // namespace
}  // namespace sturm
