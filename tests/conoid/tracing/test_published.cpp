#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "conoid/tracing/previous.h"
#include "conoid/tracing/published.h"
#include "conoid/tracing/spectacle_conoid.h"
#include "lensmodel/gaze.h"
#include "lensmodel/single_vision.h"
#include "support/drawn.h"
#include "support/fixed_rapidcheck_seed.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::degree;
using testing::drawn;

const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), along_axis(0.0, 0.0, -1.0);

Eye any_eye() {
  return Eye::with({drawn(-24, 16, 0.25), drawn(-12, 12, 0.25), drawn(0, 180, 1.0), 12e-3}, 4e-3);
}

RC_GTEST_PROP(Published, IsExactForTheNakedEye, ()) {
  const Eye eye = any_eye();
  const double vergence = drawn(0, 50, 0.1), accommodation = drawn(0, 30, 0.1);
  const auto conoid = trace_published(eye, accommodation, nullptr, along_axis);
  const Eigen::Matrix2d exact = naked_eye_footprint(eye, 1.0 / vergence, accommodation).angular;
  RC_ASSERT((angular_map(*conoid, x, y, vergence) - exact).norm() <= 1e-13);
}

RC_GTEST_PROP(Published, IsExactOnTheAxisOfARotationallySymmetricLens, ()) {
  const Eye eye = any_eye();
  const Spectacles lens = single_vision({drawn(-24, 16, 0.25)}, {});
  for (const TangentAxes axes : {TangentAxes::incidence, TangentAxes::principal}) {
    const auto conoid = trace_published(eye, 0.0, &lens, along_axis, axes);
    RC_ASSERT(conoid.has_value());
    const SpectacleConoid exact = trace_conoid(lens, along_axis, eye.rotation_center_m);
    const Eigen::Matrix2d x_over_d = exact.angular_footprint(eye.correction.matrix(), 1.3);
    RC_ASSERT((angular_map(*conoid, x, y, 1.3) - x_over_d).norm() <= 1e-12);
  }
}

RC_GTEST_PROP(Published, IsExactOnTheAxisAlongTheMeridiansOfAToricLens, ()) {
  // Eye and lens have the same meridians: nothing twists, but the larger curvature may change from one meridian to the
  // other.
  const double axis = 90.0 * *rc::gen::inRange(1, 3);
  const Eye eye = Eye::with({drawn(-24, 16, 0.25), drawn(-12, 12, 0.25), axis, 12e-3}, 4e-3);
  const Spectacles lens = single_vision({drawn(-24, 16, 0.25), drawn(-24, 24, 0.25), 180.0}, {});
  const auto conoid = trace_published(eye, 0.0, &lens, along_axis);
  RC_ASSERT(conoid.has_value());
  const SpectacleConoid exact = trace_conoid(lens, along_axis, eye.rotation_center_m);
  RC_ASSERT((angular_map(*conoid, x, y, 1.3) - exact.angular_footprint(eye.correction.matrix(), 1.3)).norm() <= 1e-12);
}

TEST(Published, IsNotExactThroughAnObliqueTorus) {
  // What the accuracy study is about: a different ellipse, near the true one. −5.00 −4.00 × 30 seen 25° aside.
  const Prescription rx{-5.0, -4.0, 30.0, 12e-3};
  const Eye eye = Eye::with(rx, 4e-3);
  const Spectacles lens = single_vision({-5.0, -4.0, 75.0}, {});
  const Eigen::Vector3d gaze = gaze_direction(25 * degree, 10 * degree);
  const SpectacleConoid exact = trace_conoid(lens, gaze, eye.rotation_center_m);
  const auto conoid = trace_published(eye, 0.0, &lens, gaze);
  ASSERT_TRUE(conoid);
  const Eigen::Matrix2d p = angular_map(*conoid, exact.exit.e1, exact.exit.e2, 1.0),
                        e = exact.angular_footprint(eye.correction.matrix(), 1.0);
  const double error = (p * p.transpose() - e * e.transpose()).norm() / (e * e.transpose()).norm();
  EXPECT_GT(error, 1e-3);
  EXPECT_LT(error, 0.3);
}

TEST(Published, Equation11FailsWhereItIsSingular) {
  // Normal incidence, axes at 45° to the refracted principal directions: both rows are (½, ½).
  const FiveVariables before{along_axis, 1.0, -1.0, x, y};
  const Eigen::Vector3d d1 = (x + y).normalized(), d2 = (y - x).normalized();
  const Eigen::Vector3d tilted = (along_axis + 0.3 * x).normalized();  // so that u lies along y
  const FiveVariables behind{along_axis, 1.0, -1.0, d1, d2};
  Eq11Failure why{};
  EXPECT_FALSE(
      refracted_semi_axes({2e-3, 1e-3}, {tilted, 1.0, -1.0, x, y}, behind, along_axis, TangentAxes::incidence, &why));
  EXPECT_EQ(why, Eq11Failure::singular);
  EXPECT_TRUE(refracted_semi_axes({2e-3, 2e-3}, before, behind, along_axis, TangentAxes::principal));
  EXPECT_FALSE(refracted_semi_axes({0.0, 1e-3}, before, before, along_axis, TangentAxes::principal, &why));
  EXPECT_EQ(why, Eq11Failure::no_length);
}

TEST(Published, Equation11FailsWhereItTurnsNegative) {
  // Refracted directions at 30° to the axes, rows (¾, ¼) and (¼, ¾): E = (1, 9) on the axes needs E' = (−3, 13).
  const Eigen::Vector3d d1 = 0.86602540378443865 * x + 0.5 * y, d2 = -0.5 * x + 0.86602540378443865 * y;
  const Eigen::Vector3d tilted = (along_axis + 0.3 * y).normalized();  // u lies along x
  Eq11Failure why{};
  EXPECT_FALSE(refracted_semi_axes({1.0, 1.0 / 3.0}, {tilted, 1.0, -1.0, x, y}, {along_axis, 1.0, -1.0, d1, d2},
                                   along_axis, TangentAxes::incidence, &why));
  EXPECT_EQ(why, Eq11Failure::negative);
}

TEST(Published, KeepsTheSectionsAxesWhereTheLensSendsOutAPlaneWave) {
  // A relaxed eye behind the lens that corrects it looks at infinity: the wave in front is plane, but the lens has
  // magnified the pupil by its cylinder. Axes of such a wave are rounding, and an ellipse put on them was off by up to
  // 0.09 D; on its own it is exact.
  const Prescription rx{-1.5, -4.0, 55.0, 12e-3};
  const Eye eye = Eye::with(rx, 4e-3);
  const Spectacles lens = single_vision(rx, {});
  const SpectacleConoid exact = trace_conoid(lens, along_axis, eye.rotation_center_m);
  for (const TangentAxes axes : {TangentAxes::incidence, TangentAxes::principal}) {
    const PublishedTrace trace = trace_published_or_why(eye, 0.0, &lens, along_axis, axes);
    EXPECT_TRUE(trace.free_axes);
    if (axes == TangentAxes::incidence) continue;  // its axes at normal incidence are any axes: 45° is possible
    ASSERT_TRUE(trace.conoid);
    EXPECT_LT((angular_map(*trace.conoid, x, y, 4.0) - exact.angular_footprint(eye.correction.matrix(), 4.0)).norm(),
              1e-12);
  }
  EXPECT_FALSE(trace_published_or_why(eye, 0.5, &lens, along_axis).free_axes);
  EXPECT_FALSE(trace_published_or_why(eye, 0.0, &lens, gaze_direction(1 * degree, 0.0)).free_axes);
  // Without a cylinder the section is a circle, which needs no axes.
  const Prescription sphere{-3.0, 0.0, 180.0, 12e-3};
  const Spectacles round = single_vision(sphere, {});
  EXPECT_FALSE(trace_published_or_why(Eye::with(sphere, 4e-3), 0.0, &round, along_axis).free_axes);
}

TEST(Published, ALostChiefRayIsNoFailureOfEquation11) {
  Spectacles small = single_vision({-3.0}, {});
  small.diameter_m = 5e-3;
  const PublishedTrace trace =
      trace_published_or_why(Eye::with({-3.0}, 4e-3), 0.0, &small, gaze_direction(40 * degree, 0.0));
  EXPECT_FALSE(trace.conoid);
  EXPECT_FALSE(trace.failure);
}

TEST(Published, Equation11ByHand) {
  // Refracted directions at 30° to the axes: rows (¾, ¼) and (¼, ¾). E' = (3, 1) makes E = (2.5, 1.5) on the axes.
  const Eigen::Vector3d d1 = 0.86602540378443865 * x + 0.5 * y, d2 = -0.5 * x + 0.86602540378443865 * y;
  const Eigen::Vector3d tilted = (along_axis + 0.3 * y).normalized();  // u lies along x
  const auto axes = refracted_semi_axes({0.63245553203367588, 0.81649658092772603}, {tilted, 1.0, -1.0, x, y},
                                        {along_axis, 1.0, -1.0, d1, d2}, along_axis, TangentAxes::incidence);
  ASSERT_TRUE(axes);
  EXPECT_NEAR(axes->first, 0.57735026918962576, 1e-15);
  EXPECT_NEAR(axes->second, 1.0, 1e-15);
}

TEST(Published, Equation11KeepsTheSigns) {
  const FiveVariables wave{along_axis, 1.0, -1.0, x, y};
  const auto axes = refracted_semi_axes({-2e-3, 1e-3}, wave, wave, along_axis, TangentAxes::principal);
  ASSERT_TRUE(axes);
  EXPECT_NEAR(axes->first, -2e-3, 1e-18);
  EXPECT_NEAR(axes->second, 1e-3, 1e-18);
}

RC_GTEST_PROP(Published, Equation12IsTheBestAccommodationOfTheNakedEye, ()) {
  const Eye eye = any_eye();
  const double vergence = drawn(0, 60, 0.1), amplitude = drawn(1, 80, 0.1);
  const auto map = [&](double a) { return angular_map(*trace_published(eye, a, nullptr, along_axis), x, y, vergence); };
  const PublishedAccommodation mix = mixed(map(0.0), map(amplitude));
  Eye best = eye;
  best.accommodation = BestAccommodation{amplitude};
  const double a = best.accommodation_for(vergence);
  RC_ASSERT(std::abs(mix.t * amplitude - a) <= 1e-12);
  RC_ASSERT((mix.map - map(a)).norm() <= 1e-12);
}

RC_GTEST_PROP(Previous, IsExactForTheNakedEye, ()) {
  const Eye eye = any_eye();
  const double d = drawn(1, 50, 0.1);
  RC_ASSERT((*previous_angular_footprint(eye, 0.5, nullptr, along_axis, d) - naked_eye_footprint(eye, d, 0.5).angular)
                .norm() <= 1e-15);
}

TEST(Previous, ThroughAirItIsTheNakedEyeFromThePupil) {
  Spectacles air;
  air.refractive_index = 1.0;
  const Eye eye = Eye::with({-1.0, -2.5, 25.0, 12e-3}, 4e-3);
  const Eigen::Vector3d gaze = gaze_direction(20 * degree, -10 * degree);
  const SpectacleConoid c = trace_conoid(air, gaze, eye.rotation_center_m);
  const double way = (c.chief_ray.origin - turned_pupil_center(gaze, eye.rotation_center_m)).norm(), d = 0.7;
  const Eigen::Matrix2d expected = naked_eye_footprint(eye, d + way, 0.0).transverse() / d;
  EXPECT_LT((*previous_angular_footprint(eye, 0.0, &air, gaze, d) - expected).norm(), 1e-13);
}

TEST(Previous, WidensByTheBendingOfTheChiefRay) {
  // A −6 D lens, looking 20° to the right: the line of sight is bent outward, by the lens's effect at the rotation
  // centre (about 1 + 25.5 mm · 6 D); the true magnification is that at the pupil (about 1 + 12 mm · 6 D), and acts in
  // both meridians.
  const Spectacles lens = single_vision({-6.0}, {});
  const Eye eye = Eye::with({0.0, 0.0, 180.0, 0.0}, 4e-3);
  const Eigen::Vector3d gaze = gaze_direction(20 * degree, 0.0);
  const Eigen::Matrix2d previous = *previous_angular_footprint(eye, 0.0, &lens, gaze, 1.0);
  const Eigen::Matrix2d exact =
      trace_conoid(lens, gaze, eye.rotation_center_m).angular_footprint(Eigen::Matrix2d::Zero(), 1.0);
  EXPECT_GT(previous(0, 0) / exact(0, 0), 1.02);
  EXPECT_LT(previous(0, 0) / exact(0, 0), 1.2);
  EXPECT_LT(previous(1, 1) / exact(1, 1), 0.98);
  EXPECT_GT(previous(1, 1) / exact(1, 1), 0.85);
}

RC_GTEST_PROP(Previous, IsInFocusWhereTheConoidIs, ()) {
  // Light goes both ways: what the eye needs and what arrives agree exactly where the footprint vanishes, whatever the
  // scaling.
  const Spectacles lens = single_vision({drawn(-24, 16, 0.25)}, {});
  const double d = drawn(3, 40, 0.1);
  const Eigen::Vector3d gaze = gaze_direction(drawn(-25, 25, degree), drawn(-25, 25, degree));
  const SpectacleConoid c = trace_conoid(lens, gaze, 13.5e-3);
  RC_PRE(c.status == LensStatus::ok);
  const Eigen::Matrix2d needed = -c.angular_q(1.0 / d).inverse() * c.angular_p(1.0 / d);
  Eye eye = Eye::with({0.0, 0.0, 180.0, 0.0}, 4e-3);
  eye.correction = PowerMatrix::from_components(needed(0, 0), needed(0, 1), needed(1, 1));
  RC_ASSERT(previous_angular_footprint(eye, 0.0, &lens, gaze, d)->norm() <= 1e-11);
}

RC_GTEST_PROP(Previous, IsExactInsideBeforeItsScaling, ()) {
  // X = P + Q S, and the wave from the object point arrives with P + Q V = 0: X = Q (S − V), whatever the gaze and the
  // lens's cylinder.
  const Eye eye = any_eye();
  const Spectacles lens = single_vision({drawn(-24, 16, 0.25), drawn(-12, 12, 0.25), drawn(0, 180, 1.0)}, {});
  const double d = drawn(3, 40, 0.1);
  const Eigen::Vector3d gaze = gaze_direction(drawn(-25, 25, degree), drawn(-25, 25, degree));
  const SpectacleConoid c = trace_conoid(lens, gaze, eye.rotation_center_m);
  RC_PRE(c.status == LensStatus::ok);
  const auto arriving = PreviousMethod(&lens, gaze, eye.rotation_center_m).vergence_at_pupil(1.0 / d);
  RC_ASSERT(arriving.has_value());
  const Eigen::Matrix2d slopes = eye.slope_matrix(0.5).matrix(), exact = c.angular_footprint(slopes, 1.0 / d);
  RC_ASSERT((c.angular_q(1.0 / d) * (slopes - *arriving) - exact).norm() <= 1e-11);
}

}  // namespace
}  // namespace sturm
