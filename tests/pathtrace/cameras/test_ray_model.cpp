#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "pathtrace/cameras/ray_model.h"
#include "support/fixed_rapidcheck_seed.h"

namespace sturm {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr RayModel all_models[] = {RayModel::pinhole, RayModel::thin_lens, RayModel::metalstigmatism,
                                   RayModel::sin2_radial, RayModel::power_matrix};

struct Situation {
  Prescription rx;
  double accommodation, focus_distance, r, phi;
};

Situation any_situation() {
  return {{*rc::gen::inRange(-40, 41) * 0.25, *rc::gen::inRange(-20, 21) * 0.25, *rc::gen::inRange(0, 1801) * 0.1, 0.0},
          *rc::gen::inRange(0, 21) * 0.25,
          *rc::gen::inRange(1, 101) * 0.05,
          *rc::gen::inRange(1, 101) * 2e-5,
          *rc::gen::inRange(0, 3600) * 0.1 * std::numbers::pi / 180.0};
}

/// docs/theory.md#2-from-a-prescription-to-a-power-matrix, written with the angle itself: P(φ) = S + C sin²(φ − α_w)
/// with α_w = 180° − AXIS.
double meridional_power(const Prescription& rx, double phi) {
  const double sine = std::sin(phi - std::numbers::pi + rx.axis_deg * std::numbers::pi / 180.0);
  return rx.sphere_D + rx.cylinder_D * sine * sine;
}

PupilRay<double> launched(RayModel model, const Situation& s) {
  const Eye eye = Eye::with(s.rx, 4e-3);
  return EyeRays<double>(model, eye, s.accommodation, s.focus_distance)
      .through(s.r * std::cos(s.phi), s.r * std::sin(s.phi));
}

// 2 mm · 30 D = 0.06 rad; angle and products each round at 1e−16 relative, P at 30 D.
constexpr double slope_tolerance = 1e-15;

RC_GTEST_PROP(RayModels, ThinLensUsesTheSphericalEquivalent, ()) {
  const Situation s = any_situation();
  const auto ray = launched(RayModel::thin_lens, s);
  const double power = s.rx.sphere_D + 0.5 * s.rx.cylinder_D - s.accommodation;
  RC_ASSERT(std::abs(ray.sx - power * s.r * std::cos(s.phi)) <= slope_tolerance);
  RC_ASSERT(std::abs(ray.sy - power * s.r * std::sin(s.phi)) <= slope_tolerance);
}

RC_GTEST_PROP(RayModels, Sin2RadialIsCollinearWithItsPupilPoint, ()) {
  const Situation s = any_situation();
  const auto ray = launched(RayModel::sin2_radial, s);
  const double power = meridional_power(s.rx, s.phi) - s.accommodation;
  RC_ASSERT(std::abs(ray.sx - power * s.r * std::cos(s.phi)) <= slope_tolerance);
  RC_ASSERT(std::abs(ray.sy - power * s.r * std::sin(s.phi)) <= slope_tolerance);
  RC_ASSERT(std::abs(ray.px * ray.sy - ray.py * ray.sx) <= slope_tolerance * s.r);
}

// docs/theory.md#6-sine-squared-interpolation-against-wavefront-theory: what sin² leaves out is tangential, r·C·sin(φ −
// α_w)·cos(φ − α_w).
RC_GTEST_PROP(RayModels, WhatSin2LeavesOutIsTangential, ()) {
  const Situation s = any_situation();
  const auto full = launched(RayModel::power_matrix, s), radial = launched(RayModel::sin2_radial, s);
  const double dx = full.sx - radial.sx, dy = full.sy - radial.sy;
  const double c = std::cos(s.phi), n = std::sin(s.phi),
               from_axis = s.phi - std::numbers::pi + s.rx.axis_deg * std::numbers::pi / 180.0;
  RC_ASSERT(std::abs(dx * c + dy * n) <= slope_tolerance);
  RC_ASSERT(std::abs((-dx * n + dy * c) - s.r * s.rx.cylinder_D * std::sin(from_axis) * std::cos(from_axis)) <=
            slope_tolerance);
}

// The slope of the power matrix is minus the gradient of the wavefront W = −½ r² (P(φ) − A), here by central
// differences.
RC_GTEST_PROP(RayModels, PowerMatrixIsTheGradientOfTheWavefront, ()) {
  const Situation s = any_situation();
  const auto wavefront = [&](double x, double y) {
    return -0.5 * (x * x + y * y) * (meridional_power(s.rx, std::atan2(y, x)) - s.accommodation);
  };
  const auto ray = launched(RayModel::power_matrix, s);
  const double h = 1e-6;  // exact for a quadratic; rounding 1e−16 · |W| / h ≤ 1e−14 with |W| ≤ 6e−5 m
  RC_ASSERT(std::abs(ray.sx + (wavefront(ray.px + h, ray.py) - wavefront(ray.px - h, ray.py)) / (2 * h)) <= 5e-14);
  RC_ASSERT(std::abs(ray.sy + (wavefront(ray.px, ray.py + h) - wavefront(ray.px, ray.py - h)) / (2 * h)) <= 5e-14);
}

RC_GTEST_PROP(RayModels, MetalstigmatismAsPrinted, ()) {
  const Situation s = any_situation();
  const double power = meridional_power(s.rx, s.phi), f = s.focus_distance + 1.0 / power;
  RC_PRE(std::abs(1.0 + s.focus_distance * power) > 1e-3);
  const auto ray = launched(RayModel::metalstigmatism, s);
  // The pole amplifies rounding: |1 + d_f P| ≥ 1e−3.
  const double tolerance = 1e-12 * (1.0 + 1.0 / std::abs(f));
  RC_ASSERT(std::abs(ray.sx + s.r * std::cos(s.phi) / f) <= tolerance);
  RC_ASSERT(std::abs(ray.sy + s.r * std::sin(s.phi) / f) <= tolerance);
  RC_ASSERT((ray.status == LaunchStatus::negative_focus) == (f < 0.0));
  RC_ASSERT(ray.status != LaunchStatus::dropped);
}

PupilRay<double> metalstigmatism(const Prescription& rx, double focus_distance, double px, double py) {
  return EyeRays<double>(RayModel::metalstigmatism, Eye::with(rx, 4e-3), 0.0, focus_distance).through(px, py);
}

TEST(Metalstigmatism, AnEmmetropeIsFocusedAtInfinity) {
  const auto ray = metalstigmatism({}, 2.0, 1e-3, -1e-3);
  EXPECT_EQ(ray.sx, 0.0);
  EXPECT_EQ(ray.sy, 0.0);
  EXPECT_EQ(ray.status, LaunchStatus::ok);
}

TEST(Metalstigmatism, RaysAtThePoleAreDropped) {
  EXPECT_EQ(metalstigmatism({-0.5, 0.0, 180.0, 0.0}, 2.0, 1e-3, 1e-3).status, LaunchStatus::dropped);
  // 0.00 −1.00 × 180, d_f = 2 m: P = −½ on the meridians at 45° only.
  EXPECT_EQ(metalstigmatism({0.0, -1.0, 180.0, 0.0}, 2.0, 1e-3, 1e-3).status, LaunchStatus::dropped);
  EXPECT_EQ(metalstigmatism({0.0, -1.0, 180.0, 0.0}, 2.0, 1e-3, 1.01e-3).status, LaunchStatus::ok);  // P < −½, f > 0
  EXPECT_EQ(metalstigmatism({0.0, -1.0, 180.0, 0.0}, 2.0, 1.01e-3, 1e-3).status,
            LaunchStatus::negative_focus);  // −½ < P < 0
}

TEST(Metalstigmatism, WeakMyopiaBendsTheWrongWay) {
  // P = −0.25 D, d_f = 2 m: f = 2 − 4 = −2 m, so the ray leaves outwards with slope +p/2.
  const auto weak = metalstigmatism({-0.25, 0.0, 180.0, 0.0}, 2.0, 1e-3, 0.0);
  EXPECT_DOUBLE_EQ(weak.sx, +0.5e-3);
  EXPECT_EQ(weak.status, LaunchStatus::negative_focus);
  // P = −4 D: f = 2 − 0.25 m.
  const auto strong = metalstigmatism({-4.0, 0.0, 180.0, 0.0}, 2.0, 1e-3, 0.0);
  EXPECT_DOUBLE_EQ(strong.sx, -1e-3 / 1.75);
  EXPECT_EQ(strong.status, LaunchStatus::ok);
}

TEST(Metalstigmatism, FocusedAtInfinityEveryRayIsParallel) {
  const auto ray = metalstigmatism({-3.0, -1.0, 30.0, 0.0}, infinity, 1e-3, 1e-3);
  EXPECT_EQ(ray.sx, 0.0);
  EXPECT_EQ(ray.sy, 0.0);
  EXPECT_EQ(ray.status, LaunchStatus::ok);
}

// Literal numbers; a mirrored AXIS changes their signs.
TEST(RayModels, Axis30IsNotAxis150) {
  const auto slope = [](RayModel model, double axis, double px, double py) {
    const auto ray = EyeRays<double>(model, Eye::with({0.0, -2.0, axis, 0.0}, 4e-3), 0.0).through(px, py);
    return Eigen::Vector2d(ray.sx, ray.sy);
  };
  EXPECT_NEAR(slope(RayModel::power_matrix, 30.0, 1e-3, 0.0).x(), -0.5e-3, 1e-17);
  EXPECT_NEAR(slope(RayModel::power_matrix, 30.0, 1e-3, 0.0).y(), -0.86602540378443865e-3, 1e-17);
  EXPECT_NEAR(slope(RayModel::power_matrix, 150.0, 1e-3, 0.0).y(), +0.86602540378443865e-3, 1e-17);
  EXPECT_NEAR(slope(RayModel::sin2_radial, 30.0, 1e-3, 1e-3).x(), -1.8660254037844386e-3, 1e-17);    // −2 sin² 75°
  EXPECT_NEAR(slope(RayModel::sin2_radial, 150.0, 1e-3, 1e-3).x(), -0.13397459621556135e-3, 1e-17);  // −2 sin² 15°
}

RC_GTEST_PROP(RayModels, FloatAndDoubleAgree, ()) {
  const Situation s = any_situation();
  const Eye eye = Eye::with(s.rx, 4e-3);
  const double px = s.r * std::cos(s.phi), py = s.r * std::sin(s.phi);
  RC_PRE(std::abs(1.0 + s.focus_distance * meridional_power(s.rx, s.phi)) > 0.1);  // float cannot follow the pole
  for (RayModel model : all_models) {
    const auto d = EyeRays<double>(model, eye, s.accommodation, s.focus_distance).through(px, py);
    const auto f = EyeRays<float>(model, eye, s.accommodation, s.focus_distance)
                       .through(static_cast<float>(px), static_cast<float>(py));
    RC_ASSERT(std::abs(static_cast<double>(f.sx) - d.sx) <= 1e-6);
    RC_ASSERT(std::abs(static_cast<double>(f.sy) - d.sy) <= 1e-6);
    RC_ASSERT(f.status == d.status);
  }
}

TEST(RayModels, TheCentralRayIsNeverBent) {
  const Eye eye = Eye::with({-3.0, -2.0, 30.0, 0.0}, 4e-3);
  for (RayModel model : all_models) {
    const auto ray = EyeRays<double>(model, eye, 1.0, 2.0).through(0.0, 0.0);
    EXPECT_EQ(ray.sx, 0.0) << name_of(model);
    EXPECT_EQ(ray.sy, 0.0) << name_of(model);
    EXPECT_EQ(ray.status, LaunchStatus::ok) << name_of(model);
  }
}

TEST(RayModels, APinholeHasNoPupil) {
  EXPECT_EQ(EyeRays<double>(RayModel::pinhole, Eye::with({}, 4e-3), 0.0).pupil_radius(), 0.0);
  EXPECT_EQ(EyeRays<double>(RayModel::power_matrix, Eye::with({}, 4e-3), 0.0).pupil_radius(), 2e-3);
}

TEST(RayCounters, CountWhatBecameOfEachRay) {
  RayCounters counters, more;
  for (LaunchStatus status :
       {LaunchStatus::ok, LaunchStatus::dropped, LaunchStatus::negative_focus, LaunchStatus::negative_focus})
    count(counters, status);
  count(more, LaunchStatus::dropped);
  counters += more;
  EXPECT_EQ(counters.launched, 5u);
  EXPECT_EQ(counters.dropped, 2u);
  EXPECT_EQ(counters.negative_focus, 2u);
}

}  // namespace
}  // namespace sturm
