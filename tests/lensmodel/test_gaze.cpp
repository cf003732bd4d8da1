#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "lensmodel/gaze.h"
#include "support/fixed_rapidcheck_seed.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::degree;

Eigen::Vector3d any_gaze() {
  return gaze_direction(*rc::gen::inRange(-800, 801) * 0.1 * degree, *rc::gen::inRange(-800, 801) * 0.1 * degree);
}

TEST(GazeDirection, RightIsPlusXAndUpIsPlusY) {
  EXPECT_LT((gaze_direction(0.0, 0.0) - Eigen::Vector3d(0.0, 0.0, -1.0)).norm(), 1e-16);
  EXPECT_LT((gaze_direction(30.0 * degree, 0.0) - Eigen::Vector3d(0.5, 0.0, -0.86602540378443865)).norm(), 1e-15);
  EXPECT_LT((gaze_direction(0.0, 30.0 * degree) - Eigen::Vector3d(0.0, 0.5, -0.86602540378443865)).norm(), 1e-15);
  EXPECT_LT((gaze_direction(90.0 * degree, 60.0 * degree) - Eigen::Vector3d(0.5, 0.86602540378443865, 0.0)).norm(),
            1e-15);
}

RC_GTEST_PROP(SmallestRotation, IsARotationThatMapsOneToTheOther, ()) {
  const Eigen::Vector3d from = any_gaze(), to = any_gaze();
  RC_PRE(from.dot(to) > -0.9);
  const Eigen::Matrix3d r = smallest_rotation(from, to);
  // 1 / (1 + cos) ≤ 10 amplifies rounding.
  RC_ASSERT((r * r.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= 1e-14);
  RC_ASSERT(r.determinant() > 0.0);
  RC_ASSERT((r * from - to).norm() <= 1e-14);
  // Smallest: it turns by the angle between the two, trace = 1 + 2 cos.
  RC_ASSERT(std::abs(r.trace() - (1.0 + 2.0 * from.dot(to))) <= 1e-14);
}

RC_GTEST_PROP(SmallestRotation, FromPrimaryGazeObeysListingsLaw, ()) {
  const Eigen::Vector3d primary(0.0, 0.0, -1.0), gaze = any_gaze();
  const Eigen::Matrix3d r = smallest_rotation(primary, gaze);
  // The axis of rotation, read off the antisymmetric part, lies in Listing's plane z = 0.
  RC_ASSERT(std::abs(r(1, 0) - r(0, 1)) <= 1e-15);
}

TEST(SmallestRotation, NoTurnIsTheIdentity) {
  EXPECT_EQ(smallest_rotation({0.0, 0.0, -1.0}, {0.0, 0.0, -1.0}), Eigen::Matrix3d::Identity());
}

TEST(TurnedPupil, MovesTowardsTheGazeAboutTheRotationCentre) {
  EXPECT_LT(turned_pupil_center({0.0, 0.0, -1.0}, 13.5e-3).norm(), 1e-18);
  const Eigen::Vector3d right = turned_pupil_center(gaze_direction(30.0 * degree, 0.0), 13.5e-3);
  EXPECT_NEAR(right.x(), 6.75e-3, 1e-15);
  EXPECT_NEAR(right.y(), 0.0, 1e-18);
  EXPECT_NEAR(right.z(), 13.5e-3 * (1.0 - 0.86602540378443865), 1e-15);
  // It stays at its distance from the rotation centre (0, 0, +13.5 mm).
  EXPECT_NEAR((right - Eigen::Vector3d(0.0, 0.0, 13.5e-3)).norm(), 13.5e-3, 1e-15);
}

TEST(Gaze, PictureJacobianIsSecantSquaredAlongTheRadiusAndSecantAcross) {
  // At 50° to the right: 2.4203 and 1.5557.
  const Eigen::Vector3d gaze = gaze_direction(0.87266462599716477, 0.0);
  const Eigen::Matrix3d turn = smallest_rotation({0.0, 0.0, -1.0}, gaze);
  const Eigen::Matrix2d j = picture_jacobian(gaze, turn.col(0), turn.col(1));
  EXPECT_NEAR(j(0, 0), 2.4202765, 1e-6);
  EXPECT_NEAR(j(1, 1), 1.5557238, 1e-6);
  EXPECT_NEAR(j(0, 1), 0.0, 1e-15);
  EXPECT_NEAR(j(1, 0), 0.0, 1e-15);
}

TEST(Gaze, PictureJacobianIsADerivative) {
  const Eigen::Vector3d gaze = gaze_direction(-0.5, 0.4);
  const Eigen::Matrix3d turn = smallest_rotation({0.0, 0.0, -1.0}, gaze);
  const Eigen::Matrix2d j = picture_jacobian(gaze, turn.col(0), turn.col(1));
  constexpr double h = 1e-6;
  for (int c : {0, 1}) {
    const Eigen::Vector2d difference =
        (picture_point(gaze + h * turn.col(c)) - picture_point(gaze - h * turn.col(c))) / (2.0 * h);
    EXPECT_LT((j.col(c) - difference).norm(), 1e-9);  // h² and 1e-16/h
  }
}

}  // namespace
}  // namespace sturm
