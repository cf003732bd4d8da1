#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "conoid/tracing/five_variables.h"
#include "conoid/tracing/ray_transfer.h"
#include "conoid/tracing/wavefront.h"
#include "lensmodel/sphere_surface.h"
#include "lensmodel/symmetric2.h"
#include "support/drawn.h"
#include "support/fixed_rapidcheck_seed.h"

namespace sturm {
namespace {
using testing::drawn;

const Eigen::Vector3d rightward = Eigen::Vector3d::UnitX(), upward = Eigen::Vector3d::UnitY(), forward(0.0, 0.0, -1.0);

Eigen::Matrix2d diagonal(double a, double b) {
  return Eigen::Vector2d(a, b).asDiagonal();
}

Eigen::Matrix2d any_symmetric(double unit) {
  const double xx = drawn(-50, 50, unit), xy = drawn(-50, 50, unit), yy = drawn(-50, 50, unit);
  Eigen::Matrix2d m;
  m << xx, xy, xy, yy;
  return m;
}

Eigen::Vector3d any_direction(const Eigen::Vector3d& about) {
  return (about + Eigen::Vector3d(drawn(-60, 60, 0.01), drawn(-60, 60, 0.01), drawn(-30, 30, 0.01))).normalized();
}

Wavefront any_wave() {
  const Eigen::Vector3d n = any_direction(forward), e1 = n.unitOrthogonal();
  return {n, e1, *rc::gen::arbitrary<bool>() ? Eigen::Vector3d(n.cross(e1)) : Eigen::Vector3d(-n.cross(e1)),
          any_symmetric(0.1)};
}

PrincipalCurvatures principal(const Eigen::Matrix2d& k, const Eigen::Vector3d& f1, const Eigen::Vector3d& f2) {
  const PrincipalValues p = principal_values(k(0, 0), k(0, 1), k(1, 1));
  const Eigen::Vector2d& h = p.high_direction;
  return {p.high, p.low, h.x() * f1 + h.y() * f2, -h.y() * f1 + h.x() * f2};
}

FiveVariables five(const Wavefront& w) {
  const PrincipalCurvatures c = principal(w.curvature, w.e1, w.e2);
  return {w.direction, c.kappa1, c.kappa2, c.e1, c.e2};
}

/// As a tensor in space, so that frames do not matter.
Eigen::Matrix3d tensor(const Wavefront& w) {
  Eigen::Matrix<double, 3, 2> e;
  e << w.e1, w.e2;
  return e * w.curvature * e.transpose();
}
Eigen::Matrix3d tensor(const FiveVariables& w) {
  return w.kappa1 * w.e1 * w.e1.transpose() + w.kappa2 * w.e2 * w.e2.transpose();
}

void expect_same(const FiveVariables& five_variables, const Wavefront& matrix) {
  RC_ASSERT((five_variables.direction - matrix.direction).norm() <= 1e-15);
  RC_ASSERT((tensor(five_variables) - tensor(matrix)).norm() <= 1e-12 * std::max(1.0, tensor(matrix).norm()));
}

TEST(Transfer, AConvergingWaveBendsMoreUntilItsFocus) {
  const Wavefront wave{forward, rightward, upward, diagonal(2.0, -4.0)};
  const Wavefront moved = *transferred(wave, 0.25);
  EXPECT_NEAR(moved.curvature(0, 0), 4.0, 1e-15);   // the centre at 0.5 m is 0.25 m away now
  EXPECT_NEAR(moved.curvature(1, 1), -2.0, 1e-15);  // that at −0.25 m is 0.5 m behind
  EXPECT_FALSE(transferred(wave, 0.5));
  EXPECT_NEAR(transferred(wave, 0.75)->curvature(0, 0), -4.0, 1e-14);
}

TEST(Transfer, FiveVariablesGoThroughAFocus) {
  const FiveVariables wave{forward, 2.0, 0.0, rightward, upward};
  const FiveVariables focus = transferred(wave, 0.5);
  EXPECT_TRUE(std::isinf(focus.kappa1));
  EXPECT_EQ(focus.kappa2, 0.0);
  EXPECT_NEAR(transferred(focus, 0.25).kappa1, -4.0, 1e-15);
}

RC_GTEST_PROP(Transfer, MayBeSplit, ()) {
  const Wavefront wave = any_wave();
  const double d1 = drawn(-40, 40, 1e-3), d2 = drawn(-40, 40, 1e-3);  // short of any focus: |K| < 10 /m
  const Wavefront once = *transferred(wave, d1 + d2), twice = *transferred(*transferred(wave, d1), d2);
  RC_ASSERT((once.curvature - twice.curvature).norm() <= 1e-12 * std::max(1.0, once.curvature.norm()));
  expect_same(transferred(five(wave), d1), *transferred(wave, d1));
}

TEST(Refraction, CoddingtonByHand) {
  // Plane wave, 30° onto a sphere R = 0.1 m whose centre lies ahead, n = 1 → 1.5: cos φ' = √8/3. Numerator 1.5 cos φ' −
  // cos 30° = 0.548188; sagittal 0.548188/(1.5·0.1) = 3.654588, tangential that / cos²φ' = 9/8 of it.
  const Eigen::Vector3d normal = forward, n(0.5, 0.0, -0.86602540378443865);  // plane of incidence x–z: sagittal is y
  const auto at = Interface::refracting(n, normal, 1.0, 1.5);
  ASSERT_TRUE(at);
  const Wavefront out = through(Wavefront{n, at->u, at->v, Eigen::Matrix2d::Zero()}, *at, diagonal(10.0, 10.0));
  EXPECT_NEAR(std::abs(out.e1.dot(upward)), 1.0, 1e-15);
  EXPECT_NEAR(out.curvature(0, 0), 3.6545877239243756, 1e-13);
  EXPECT_NEAR(out.curvature(1, 1), 4.1114111894149224, 1e-13);
  EXPECT_NEAR(out.curvature(0, 1), 0.0, 1e-15);
  EXPECT_NEAR(out.direction.x(), 1.0 / 3.0, 1e-16);
}

TEST(Refraction, NormalIncidenceTakesAnyFrame) {
  const auto at = Interface::refracting(forward, forward, 1.0, 1.5);
  const Wavefront out = through(Wavefront{forward, rightward, upward, diagonal(1.0, -2.0)}, *at, diagonal(6.0, 6.0))
                            .on(rightward, upward);
  EXPECT_NEAR(out.curvature(0, 0), (1.0 + 0.5 * 6.0) / 1.5, 1e-15);
  EXPECT_NEAR(out.curvature(1, 1), (-2.0 + 0.5 * 6.0) / 1.5, 1e-15);
}

TEST(Refraction, NearlyNormalIncidenceKeepsItsFrameInTheTangentPlane) {
  // N × n is rounded to 1e-16 whatever its length: at an incidence of 1e-8 it leaned out of the tangent plane by 1e-8,
  // and the curvature of a surface inclined to the lens's axis was wrong by as much. A back surface nearly concentric
  // with the eye's centre of rotation is met like that by every oblique gaze; sturm stress found it there.
  const Eigen::Vector3d n = Eigen::Vector3d(0.4, -0.3, -0.8).normalized();
  for (const double incidence : {1e-6, 1e-7, 1e-8, 2e-9}) {
    const Eigen::Vector3d direction = (n + incidence * Eigen::Vector3d(0.7, 0.2, 0.35)).normalized();
    const auto at = Interface::refracting(direction, n, 1.0, 1.5);
    ASSERT_TRUE(at);
    // A few roundings of numbers of size 1, whatever the incidence.
    EXPECT_LT(std::abs(at->u.dot(n)), 1e-15) << incidence;
    EXPECT_LT(std::abs(at->u.dot(direction)), 1e-15) << incidence;
    EXPECT_NEAR(at->u.norm(), 1.0, 1e-15) << incidence;
    // A sphere of 1 D about the axis z has that curvature on every tangent frame: K = -1 D, and no twist.
    const Eigen::Vector3d p = -n;  // where the unit sphere's outward normal is n
    const auto sphere = SphereSurface{1.0}.sag(p.x(), p.y());
    ASSERT_TRUE(sphere);
    EXPECT_LT((tangent_curvature(*sphere, at->u, at->tangent) + Eigen::Matrix2d::Identity()).norm(), 1e-14)
        << incidence;
  }
}

TEST(Refraction, TotalReflectionIsNoInterface) {
  const Eigen::Vector3d steep(0.8, 0.0, -0.6);
  EXPECT_FALSE(Interface::refracting(steep, forward, 1.5, 1.0));
  EXPECT_TRUE(Interface::refracting(steep, forward, 1.0, 1.5));
  EXPECT_FALSE(
      refracted({steep, 1.0, 1.0, upward, steep.cross(upward)}, forward, {0.0, 0.0, rightward, upward}, 1.5, 1.0));
}

TEST(Reflection, AConcaveMirrorFocusesAtHalfItsRadius) {
  // R = 0.4 m, centre on the side that the light comes from.
  const Interface at = Interface::reflecting(forward, forward);
  const Wavefront out =
      through(Wavefront{forward, rightward, upward, Eigen::Matrix2d::Zero()}, at, diagonal(-2.5, -2.5));
  EXPECT_NEAR((out.direction + forward).norm(), 0.0, 1e-16);
  EXPECT_NEAR(out.curvature(0, 0), 5.0, 1e-15);
  EXPECT_NEAR(out.curvature(1, 1), 5.0, 1e-15);
}

TEST(Reflection, AFlatMirrorKeepsTheWave) {
  const Eigen::Vector3d n(0.6, 0.0, -0.8);
  const Interface at = Interface::reflecting(n, forward);
  const Wavefront out = through(Wavefront{n, at.u, at.v, diagonal(3.0, -1.0)}, at, Eigen::Matrix2d::Zero());
  EXPECT_NEAR(out.curvature(0, 0), 3.0, 1e-15);
  EXPECT_NEAR(out.curvature(1, 1), -1.0, 1e-15);
}

RC_GTEST_PROP(FiveVariables, AgreeWithTheMatrixForm, ()) {
  const Wavefront wave = any_wave();
  const Eigen::Vector3d normal = any_direction(wave.direction);
  RC_PRE(normal.dot(wave.direction) > 0.3);
  const double before = drawn(100, 190, 0.01), behind = drawn(100, 190, 0.01);
  const Eigen::Matrix2d surface = any_symmetric(1.0);
  if (const auto at = Interface::refracting(wave.direction, normal, before, behind)) {
    RC_PRE(at->cos_out > 0.1);
    const auto out = refracted(five(wave), normal, principal(surface, at->u, at->tangent), before, behind);
    RC_ASSERT(out.has_value());
    expect_same(*out, through(wave, *at, surface));
  }
  const Interface mirror = Interface::reflecting(wave.direction, normal);
  expect_same(reflected(five(wave), normal, principal(surface, mirror.u, mirror.tangent)),
              through(wave, mirror, surface));
  expect_same(through_thin_lens(five(wave), principal(surface, wave.e1, wave.e2)), through_thin_lens(wave, surface));
}

RC_GTEST_PROP(RayTransfer, CarriesTheSameWavefront, ()) {
  // K = −B A⁻¹ of the rays, against K through the same refraction and transfer.
  const Wavefront wave = any_wave();
  const Eigen::Vector2d gradient(drawn(-50, 50, 0.01), drawn(-50, 50, 0.01));
  const Sag surface{0.0, gradient, any_symmetric(0.5)};
  const auto at = Interface::refracting(wave.direction, outward_normal(surface), 1.0, 1.6);
  RC_PRE(outward_normal(surface).dot(wave.direction) > 0.3);
  const double d = drawn(1, 40, 1e-3);
  const RayTransfer rays =
      transferred(through(transferred(RayTransfer::start(wave.direction, wave.e1, wave.e2), d), *at, surface), d);
  const auto arrived = transferred(wave, d);
  RC_PRE(arrived.has_value());
  const Wavefront behind = through(*arrived, *at, surface);
  const auto out = transferred(behind, d);
  RC_PRE(out.has_value());
  const Eigen::Matrix2d a = rays.offsets(-wave.curvature), k = -rays.slopes(-wave.curvature) * a.inverse();
  RC_PRE(std::abs(a.determinant()) > 0.01);
  RC_ASSERT((k - out->on(rays.e1, rays.e2).curvature).norm() <=
            1e-11 * std::max(1.0, k.norm()));  // 1/det ≤ 100 amplifies rounding
}

}  // namespace
}  // namespace sturm
