#include <gtest/gtest.h>

#include <limits>

#include "conoid/tracing/clear_vision.h"
#include "conoid/tracing/turned_eye.h"
#include "lensmodel/gaze.h"
#include "lensmodel/needed_power.h"
#include "lensmodel/single_vision.h"

namespace sturm {
namespace {

const Eigen::Vector3d primary_gaze(0.0, 0.0, -1.0);

Eye eye_of(double sphere_D, double cylinder_D, const Accommodation& accommodation) {
  return Eye::with({.sphere_D = sphere_D, .cylinder_D = cylinder_D, .axis_deg = 30.0}, 4e-3, accommodation);
}

TEST(TurnedEye, IsTheNakedEyeOrItsLens) {
  const Eye eye = eye_of(-2.0, -1.5, FixedAccommodation{0.5, 0.0});
  const Spectacles lens = single_vision(needed_power(eye, 12e-3), {});
  const Eigen::Vector3d gaze = gaze_direction(0.3, -0.2);
  EXPECT_EQ(TurnedEye(eye, nullptr, gaze).footprint(0.5).angular, naked_eye_footprint(eye, 0.5).angular);
  const TurnedEye worn(eye, &lens, gaze);
  const SpectacleConoid conoid = trace_conoid(lens, gaze, eye.rotation_center_m);
  EXPECT_EQ(worn.footprint(0.5).angular, spectacle_footprint(conoid, eye, 0.5, 0.5).angular);
  EXPECT_EQ(worn.chief_ray().origin, conoid.chief_ray.origin);
  EXPECT_EQ(TurnedEye(eye, &lens, gaze_direction(1.4, 0.0)).status(), LensStatus::missed_lens);
}

TEST(TurnedEye, ItsOwnLensMakesADistantPointSharp) {
  const Eye eye = eye_of(-2.0, -1.5, RelaxedAccommodation{});
  const Spectacles lens = single_vision(needed_power(eye, 12e-3), {});
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_LT(TurnedEye(eye, &lens, primary_gaze).footprint(infinity).angular.norm(), 1e-12);
}

TEST(ClearVision, OfAMyopeLiesAboutTheFarPoint) {
  // |V + F| a ≤ limit: V = 3 ± limit/a.
  const TurnedEye eye(eye_of(-3.0, 0.0, RelaxedAccommodation{}), nullptr, primary_gaze);
  const ClearVision clear = clear_vision(eye, 2e-3, 1e-3);
  ASSERT_TRUE(clear.interval);
  EXPECT_NEAR(clear.interval->far_vergence_D, 2.5, 1e-9);
  EXPECT_NEAR(clear.interval->near_vergence_D, 3.5, 1e-9);
  EXPECT_NEAR(clear.best_vergence_D, 3.0, 1e-9);
}

TEST(ClearVision, AccommodationBringsItNearer) {
  const TurnedEye eye(eye_of(-1.0, 0.0, BestAccommodation{4.0}), nullptr, primary_gaze);
  const ClearVision clear = clear_vision(eye, 2e-3, 1e-3);
  ASSERT_TRUE(clear.interval);
  EXPECT_NEAR(clear.interval->far_vergence_D, 0.5, 1e-9);
  EXPECT_NEAR(clear.interval->near_vergence_D, 5.5, 1e-9);
}

TEST(ClearVision, OfAnAstigmatistNeedsALimitBeyondHalfOfTheCylinder) {
  // Principal powers −1 and −3: the larger semi-axis is least half way between, a · 1 D.
  const TurnedEye eye(eye_of(-1.0, -2.0, RelaxedAccommodation{}), nullptr, primary_gaze);
  const ClearVision blurred = clear_vision(eye, 2e-3, 1.9e-3), clear = clear_vision(eye, 2e-3, 2.2e-3);
  EXPECT_FALSE(blurred.interval);
  EXPECT_NEAR(blurred.best_vergence_D, 2.0, 1e-8);
  EXPECT_NEAR(blurred.best_semi_major_rad, 2e-3, 1e-11);
  ASSERT_TRUE(clear.interval);
  EXPECT_NEAR(clear.interval->far_vergence_D, 1.9, 1e-9);
  EXPECT_NEAR(clear.interval->near_vergence_D, 2.1, 1e-9);
}

TEST(ClearVision, EndsAtInfinity) {
  const TurnedEye eye(eye_of(0.0, 0.0, RelaxedAccommodation{}), nullptr, primary_gaze);
  const ClearVision clear = clear_vision(eye, 2e-3, 1e-3);
  ASSERT_TRUE(clear.interval);
  EXPECT_EQ(clear.interval->far_vergence_D, 0.0);
  EXPECT_NEAR(clear.interval->near_vergence_D, 0.5, 1e-9);
}

}  // namespace
}  // namespace sturm
