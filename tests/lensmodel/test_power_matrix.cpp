#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "lensmodel/ellipse.h"
#include "lensmodel/eye.h"
#include "lensmodel/power_matrix.h"
#include "support/fixed_rapidcheck_seed.h"

namespace sturm {
namespace {

constexpr double half_root_3 = 0.86602540378443865;

// A mirrored frame is invisible at AXIS 90 and 180 and in the size of a blur: only the sign of xy tells it.
TEST(PowerMatrix, Axis30TurnsTheOtherWayThanAxis150) {
  // 0.00 −2.00 × 30: the examiner's 30° line runs at 150° for the wearer (from the lower right to the upper left), so
  // the power acts along 60°.
  const PowerMatrix f30 = PowerMatrix::from({0.0, -2.0, 30.0, 0.0});
  EXPECT_NEAR(f30.xx(), -0.5, 1e-15);
  EXPECT_NEAR(f30.xy(), -half_root_3, 1e-15);
  EXPECT_NEAR(f30.yy(), -1.5, 1e-15);
  const PowerMatrix f150 = PowerMatrix::from({0.0, -2.0, 150.0, 0.0});
  EXPECT_NEAR(f150.xx(), -0.5, 1e-15);
  EXPECT_NEAR(f150.xy(), +half_root_3, 1e-15);
  EXPECT_NEAR(f150.yy(), -1.5, 1e-15);
}

TEST(PowerMatrix, ACylinderHasNoPowerAlongItsAxis) {
  // 0.00 −2.00 × 30: along the wearer's 150° nothing, across (60°) everything.
  const PowerMatrix f = PowerMatrix::from({0.0, -2.0, 30.0, 0.0});
  EXPECT_LT(f.slope({-half_root_3, 0.5}).norm(), 1e-15);
  const Eigen::Vector2d across(0.5, half_root_3);
  EXPECT_LT((f.slope(across) + 2.0 * across).norm(), 1e-15);
}

TEST(PowerMatrix, AxisAtMultiplesOf45IsExact) {
  EXPECT_EQ(PowerMatrix::from({1.0, -2.0, 180.0, 0.0}).matrix(), (Eigen::Matrix2d() << 1.0, 0.0, 0.0, -1.0).finished());
  EXPECT_EQ(PowerMatrix::from({1.0, -2.0, 90.0, 0.0}).matrix(), (Eigen::Matrix2d() << -1.0, 0.0, 0.0, 1.0).finished());
  const PowerMatrix oblique = PowerMatrix::from({0.0, -2.0, 45.0, 0.0});
  EXPECT_EQ(oblique.xx(), oblique.yy());
  EXPECT_NEAR(oblique.xy(), -1.0,
              1e-15);  // examiner's J45 = +1 for a minus cylinder × 45; the wearer's xy is its negative
}

TEST(PowerMatrix, Axis0IsAxis180) {
  EXPECT_EQ(PowerMatrix::from({-1.25, -0.75, 0.0, 0.0}).matrix(),
            PowerMatrix::from({-1.25, -0.75, 180.0, 0.0}).matrix());
}

RC_GTEST_PROP(PowerMatrix, WithoutCylinderTheAxisDoesNotMatter, ()) {
  const double sphere = *rc::gen::inRange(-80, 81) * 0.25, axis = *rc::gen::inRange(0, 18001) * 0.01;
  RC_ASSERT(PowerMatrix::from({sphere, 0.0, axis, 0.0}).matrix() == PowerMatrix::scalar(sphere).matrix());
}

RC_GTEST_PROP(PowerMatrix, EulersTheoremAlongEveryMeridian, ()) {
  const Prescription rx{*rc::gen::inRange(-80, 81) * 0.25, *rc::gen::inRange(-40, 41) * 0.25,
                        *rc::gen::inRange(0, 1801) * 0.1, 0.0};
  const double phi = *rc::gen::inRange(0, 3600) * 0.1 * std::numbers::pi / 180.0;
  const Eigen::Vector2d e(std::cos(phi), std::sin(phi));
  // METALSTIGMATISM writes sin²(φ + AXIS).
  const double sine = std::sin(phi + rx.axis_deg * std::numbers::pi / 180.0);
  RC_ASSERT(std::abs(e.dot(PowerMatrix::from(rx).slope(e)) - (rx.sphere_D + rx.cylinder_D * sine * sine)) <= 1e-13);
}

RC_GTEST_PROP(PowerMatrix, ReadingBackAPrescription, ()) {
  const Prescription rx{*rc::gen::inRange(-80, 81) * 0.25, -0.25 * *rc::gen::inRange(1, 41),
                        static_cast<double>(*rc::gen::inRange(1, 181)), 0.0};
  const Prescription back = PowerMatrix::from(rx).as_prescription();
  RC_ASSERT(std::abs(back.sphere_D - rx.sphere_D) <= 1e-13);
  RC_ASSERT(std::abs(back.cylinder_D - rx.cylinder_D) <= 1e-13);
  // Rounding of the matrix (4e-15 D) over the cylinder (0.25 D), in degrees.
  RC_ASSERT(std::abs(std::remainder(back.axis_deg - rx.axis_deg, 180.0)) <= 4e-12);
  RC_ASSERT(back.axis_deg > 0.0 && back.axis_deg <= 180.0);
}

// Which focal line comes first. −1.00 −2.00 × 30, relaxed: rays leave with slopes −1/m along the wearer's 150° and −3/m
// along 60°.
TEST(PowerMatrix, TheStrongerMeridianFocusesFirst) {
  const Eye eye = Eye::with({-1.0, -2.0, 30.0, 0.0}, 4e-3);
  const Eigen::Matrix2d s = eye.slope_matrix(0.0).matrix();
  const auto at = [&](double d) {
    return Ellipse::image_of_disc(Eigen::Matrix2d::Identity() + d * s, eye.pupil_radius_m);
  };

  const Ellipse first = at(1.0 / 3.0);  // the 60° meridian is in focus: the line lies along 150° ≡ −30°
  EXPECT_NEAR(first.semi_major, 2e-3 * 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(first.semi_minor, 0.0, 1e-18);
  EXPECT_NEAR(*first.orientation_deg, -30.0, 1e-12);

  const Ellipse confusion = at(0.5);  // 1 + d·S = +½ and −½: the circle of least confusion
  EXPECT_NEAR(confusion.semi_major, 1e-3, 1e-15);
  EXPECT_NEAR(confusion.semi_minor, 1e-3, 1e-15);

  const Ellipse second = at(1.0);
  EXPECT_NEAR(second.semi_major, 2e-3 * 2.0, 1e-15);
  EXPECT_NEAR(second.semi_minor, 0.0, 1e-15);
  EXPECT_NEAR(*second.orientation_deg, 60.0, 1e-12);

  // Signed: before the first line a ray is on its own side of the axis, after it on the other.
  const Eigen::Vector2d p = 2e-3 * Eigen::Vector2d(0.5, half_root_3);
  EXPECT_NEAR((p + 0.1 * s * p).x(), 1e-3 * 0.7, 1e-15);
  EXPECT_NEAR((p + 0.5 * s * p).x(), 1e-3 * -0.5, 1e-15);
}

TEST(PowerMatrix, AtTheCorneaAMyopeNeedsLessAndAHyperopeMore) {
  EXPECT_NEAR(power_at_cornea({-10.0, 0.0, 180.0, 0.012}).xx(), -10.0 / 1.12, 1e-14);
  EXPECT_NEAR(power_at_cornea({+10.0, 0.0, 180.0, 0.012}).xx(), +10.0 / 0.88, 1e-14);
  EXPECT_EQ(power_at_cornea({-10.0, -2.0, 30.0, 0.0}).matrix(), PowerMatrix::from({-10.0, -2.0, 30.0, 0.0}).matrix());
}

RC_GTEST_PROP(PowerMatrix, MovingThereAndBackIsTheSameLens, ()) {
  const Prescription rx{*rc::gen::inRange(-80, 81) * 0.25, *rc::gen::inRange(-40, 41) * 0.25,
                        *rc::gen::inRange(0, 1801) * 0.1, 0.0};
  const PowerMatrix f = PowerMatrix::from(rx);
  const double d = *rc::gen::inRange(0, 21) * 1e-3;
  // |dF| ≤ 0.6, so det(I − dF) ≥ 0.16: condition below 50 at 30 D.
  RC_ASSERT((f.moved_towards_eye(d).moved_towards_eye(-d).matrix() - f.matrix()).cwiseAbs().maxCoeff() <= 2e-13);
}

TEST(PowerMatrix, VertexDistanceAtAFocalLineIsAnError) {
  EXPECT_THROW(power_at_cornea({40.0, 0.0, 180.0, 0.025}), std::domain_error);  // both meridians
  EXPECT_THROW(power_at_cornea({20.0, 20.0, 30.0, 0.025}), std::domain_error);  // only the one across the axis
  EXPECT_THROW(power_at_cornea({20.0, 20.0, 30.0, 0.05}), std::domain_error);   // only the one along it
  EXPECT_THROW(Eye::with({40.0, 0.0, 180.0, 0.025}, 4e-3), std::domain_error);
  EXPECT_NO_THROW(power_at_cornea({20.0, 20.0, 30.0, 0.024}));
}

}  // namespace
}  // namespace sturm
