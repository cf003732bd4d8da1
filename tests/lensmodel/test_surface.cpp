#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "lensmodel/bracketed_root.h"
#include "lensmodel/surface.h"
#include "support/drawn.h"
#include "support/fixed_rapidcheck_seed.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::drawn;
using testing::mm;

/// Curvatures from 1/−40 to 1/40 mm, zero included.
double any_curvature() {
  return drawn(-25, 25, 1.0);
}

Surface any_surface() {
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      return SphereSurface{any_curvature()};
    case 1:
      return TorusSurface(any_curvature(), any_curvature(), drawn(0, 180, 1.0));
    default:
      return ConicSurface{any_curvature(), drawn(-30, 10, 0.1)};
  }
}

TEST(Sag, IsPositiveWhereTheCentreLiesOnTheEyesSide) {
  // 30-40-50 triangle: 50 mm − 40 mm.
  EXPECT_NEAR(SphereSurface{20.0}.sag(30 * mm, 0.0)->value, 10 * mm, 1e-17);
  EXPECT_NEAR(SphereSurface{-20.0}.sag(0.0, 30 * mm)->value, -10 * mm, 1e-17);
  EXPECT_EQ(SphereSurface{0.0}.sag(1.0, 2.0)->value, 0.0);
  EXPECT_FALSE(SphereSurface{20.0}.sag(51 * mm, 0.0));
}

TEST(Sag, OfATorus) {
  // Generator of radius 30: at 18 across it stands at 30 − 24 = 6. Its circle about the axis at 50 has the radius 44:
  // at 26.4 along the sweep it stands at 50 − 35.2 = 14.8. Sweep along the examiner's 180°, that is horizontally.
  const TorusSurface torus(20.0, 1.0 / (30 * mm), 180.0);
  EXPECT_NEAR(torus.sag(26.4 * mm, 18 * mm)->value, 14.8 * mm, 1e-16);
  EXPECT_NEAR(torus.sag(-26.4 * mm, -18 * mm)->value, 14.8 * mm, 1e-16);
  EXPECT_FALSE(torus.sag(0.0, 31 * mm));
  EXPECT_FALSE(torus.sag(45 * mm, 18 * mm));
}

TEST(Sag, SweepMeridian30LiesAlongTheWearers150) {
  // A cylinder with power along the sweep only: no sag across it. (−√3/2, 1/2) is 150°, (1/2, √3/2) is 60°, (√3/2, 1/2)
  // would be 30°.
  const TorusSurface cylinder(20.0, 0.0, 30.0);
  EXPECT_NEAR(cylinder.sag(0.5 * 30 * mm, 0.86602540378443865 * 30 * mm)->value, 0.0, 1e-17);
  EXPECT_NEAR(cylinder.sag(-0.86602540378443865 * 30 * mm, 0.5 * 30 * mm)->value, 10 * mm, 1e-16);
  EXPECT_NEAR(cylinder.sag(0.86602540378443865 * 30 * mm, 0.5 * 30 * mm)->value, 50 * mm - 47.69696007084728 * mm,
              1e-15);  // √(50² − 15²)
}

TEST(Sag, Axis0And180AreOneMeridian) {
  const TorusSurface a(20.0, 10.0, 0.0), b(20.0, 10.0, 180.0);
  EXPECT_EQ(a.sag(3 * mm, 7 * mm)->value, b.sag(3 * mm, 7 * mm)->value);
  EXPECT_EQ(a.sag(3 * mm, 7 * mm)->hessian, b.sag(3 * mm, 7 * mm)->hessian);
}

TEST(Sag, OfConics) {
  EXPECT_NEAR((ConicSurface{20.0, -1.0}.sag(0.0, 10 * mm)->value), 1 * mm, 1e-17);  // parabola: r²/(2R)
  // Ellipsoid k = 3, R = 50: half axes R/(1 + k) = 12.5 along z and R/√(1 + k) = 25 across; at r = 15 it stands at 12.5
  // (1 − 0.8).
  EXPECT_NEAR((ConicSurface{20.0, 3.0}.sag(15 * mm, 0.0)->value), 2.5 * mm, 1e-17);
  EXPECT_FALSE((ConicSurface{20.0, 3.0}.sag(26 * mm, 0.0)));
}

RC_GTEST_PROP(Sag, DerivativesAreThoseOfTheHeight, ()) {
  const Surface surface = any_surface();
  const double x = drawn(-100, 100, 0.1 * mm), y = drawn(-100, 100, 0.1 * mm), h = 1e-5;
  const auto here = sag(surface, x, y);
  RC_PRE(here.has_value());
  const auto z = [&](double dx, double dy) { return sag(surface, x + dx, y + dy)->value; };
  const Eigen::Vector2d gradient((z(h, 0) - z(-h, 0)) / (2 * h), (z(0, h) - z(0, -h)) / (2 * h));
  // O(h²) times the third derivative, which curvatures of 25 /m at up to 14 mm keep below 1e4 /m².
  RC_ASSERT((gradient - here->gradient).norm() <= 1e4 * h * h);
  const auto slope = [&](double dx, double dy) { return sag(surface, x + dx, y + dy)->gradient; };
  Eigen::Matrix2d hessian;
  hessian << (slope(h, 0) - slope(-h, 0)) / (2 * h), (slope(0, h) - slope(0, -h)) / (2 * h);
  RC_ASSERT((hessian - here->hessian).norm() <= 1e6 * h * h);  // fourth derivative, below 1e6 /m³
}

RC_GTEST_PROP(Sag, ATorusOfTwoEqualRadiiIsASphere, ()) {
  const double c = any_curvature(), x = drawn(-100, 100, 0.1 * mm), y = drawn(-100, 100, 0.1 * mm);
  const Sag sphere = *SphereSurface{c}.sag(x, y), torus = *TorusSurface(c, c, drawn(0, 180, 1.0)).sag(x, y),
            conic = *ConicSurface{c, 0.0}.sag(x, y);
  RC_ASSERT(std::abs(sphere.value - torus.value) <= 1e-17);
  RC_ASSERT((sphere.gradient - torus.gradient).norm() <= 1e-14);
  RC_ASSERT((sphere.hessian - torus.hessian).norm() <= 1e-12);
  RC_ASSERT(sphere.hessian == conic.hessian);
}

TEST(TangentCurvature, IsNegativeWhereTheCentreLiesOnTheEyesSide) {
  const Sag there = *SphereSurface{20.0}.sag(12 * mm, -9 * mm);
  const Eigen::Vector3d n = outward_normal(there), u = n.unitOrthogonal(), w = n.cross(u);
  EXPECT_LT(n.z(), 0.0);
  // A sphere bends alike everywhere and in every direction: −1/R.
  EXPECT_LT((tangent_curvature(there, u, w) + 20.0 * Eigen::Matrix2d::Identity()).norm(), 1e-13);
}

RC_GTEST_PROP(Intersect, FindsThePointThatTheRayIsAimedAt, ()) {
  const Surface surface = any_surface();
  const Eigen::Vector2d xy(drawn(-150, 150, 0.1 * mm), drawn(-150, 150, 0.1 * mm));
  const auto there = sag(surface, xy.x(), xy.y());
  RC_PRE(there.has_value());
  const Eigen::Vector3d target(xy.x(), xy.y(), there->value),
      eye(drawn(-90, 90, 0.1 * mm), drawn(-90, 90, 0.1 * mm), 25 * mm);
  const LightRay ray{eye, (target - eye).normalized()};
  // In front of the surface, and the first crossing: no steeper than 60° on it.
  RC_PRE(outward_normal(*there).dot(ray.direction) > 0.5 && sag(surface, eye.x(), eye.y()) &&
         sag(surface, eye.x(), eye.y())->value < eye.z());
  const SurfaceHit hit = intersect(surface, ray, 35 * mm);
  RC_ASSERT(hit.status == LensStatus::ok);
  // The iteration stops within 16 units in the last place of 40 mm, 1.4e-16; rounding of height and direction over cos
  // φ > 0.5 adds as much.
  RC_ASSERT((hit.position - target).norm() <= 5e-16);
}

RC_GTEST_PROP(Intersect, NewtonAndTheClosedFormOfTheSphereAgree, ()) {
  const double c = any_curvature();
  const Eigen::Vector3d eye(drawn(-90, 90, 0.1 * mm), drawn(-90, 90, 0.1 * mm), 25 * mm);
  const LightRay ray{eye, Eigen::Vector3d(drawn(-100, 100, 0.01), drawn(-100, 100, 0.01), -1.0).normalized()};
  const SurfaceHit closed = intersect(SphereSurface{c}, ray, 35 * mm),
                   newton = intersect(ConicSurface{c, 0.0}, ray, 35 * mm),
                   torus = intersect(TorusSurface(c, c, 20.0), ray, 35 * mm);
  RC_PRE(closed.status != LensStatus::ok ||
         outward_normal(closed.sag).dot(ray.direction) > 0.05);  // grazing rays may differ
  RC_ASSERT(closed.status == newton.status && closed.status == torus.status);
  if (closed.status == LensStatus::ok) {
    RC_ASSERT(std::abs(closed.distance - newton.distance) <= 1e-15);  // rounding over cos φ ≥ 0.05
    RC_ASSERT(std::abs(closed.distance - torus.distance) <= 1e-15);
  }
}

class Misses : public ::testing::TestWithParam<int> {
 protected:
  static Surface shape(double curvature) {
    switch (GetParam()) {
      case 0:
        return SphereSurface{curvature};
      case 1:
        return TorusSurface(curvature, curvature, 30.0);
      default:
        return ConicSurface{curvature, 0.0};
    }
  }
};
INSTANTIATE_TEST_SUITE_P(SphereTorusConic, Misses, ::testing::Range(0, 3));

const Eigen::Vector3d outward(0.0, 0.0, -1.0);

TEST_P(Misses, TheRimBelongsToTheLens) {
  EXPECT_EQ(intersect(shape(10.0), {{20 * mm, 0.0, 30 * mm}, outward}, 20 * mm).status, LensStatus::ok);
  EXPECT_EQ(intersect(shape(10.0), {{20.001 * mm, 0.0, 30 * mm}, outward}, 20 * mm).status, LensStatus::missed_lens);
}

TEST_P(Misses, ARayPastTheSurfaceWithinTheRim) {
  // The surface ends at its radius of 30 mm, the rim lies at 35 mm.
  EXPECT_EQ(intersect(shape(1.0 / (30 * mm)), {{29 * mm, 0.0, 40 * mm}, outward}, 35 * mm).status, LensStatus::ok);
  EXPECT_EQ(intersect(shape(1.0 / (30 * mm)), {{31 * mm, 0.0, 40 * mm}, outward}, 35 * mm).status,
            LensStatus::missed_lens);
}

TEST_P(Misses, ACrossingJustBeforeTheSurfacesEdgeIsFound) {
  // Aimed at the height 29.5 of a surface that ends at 30, within a rim of 35 mm: z = 30 − √(30² − 29.5²) = 24.545644
  const Eigen::Vector3d target(29.5 * mm, 0.0, 24.545643942682144 * mm), eye(0.0, 0.0, 30 * mm);
  const SurfaceHit hit = intersect(shape(1.0 / (30 * mm)), {eye, (target - eye).normalized()}, 35 * mm);
  ASSERT_EQ(hit.status, LensStatus::ok);
  EXPECT_LT((hit.position - target).norm(), 1e-15);
}

TEST_P(Misses, TheOtherSheetIsNotTheSurface) {
  // From z = 70 mm, beyond the centre at 30 mm, a ray sideways crosses the far hemisphere only.
  const Eigen::Vector3d sideways = Eigen::Vector3d(1.0, 0.0, -0.1).normalized();
  EXPECT_EQ(intersect(shape(1.0 / (30 * mm)), {{0.0, 0.0, 55 * mm}, sideways}, 35 * mm).status,
            LensStatus::missed_lens);
}

TEST_P(Misses, ARayThatLeavesTheSurfaceBehind) {
  EXPECT_EQ(intersect(shape(10.0), {{0.0, 0.0, -1 * mm}, outward}, 35 * mm).status, LensStatus::missed_lens);
  EXPECT_EQ(intersect(shape(10.0), {{0.0, 0.0, 10 * mm}, -outward}, 35 * mm).status, LensStatus::missed_lens);
  EXPECT_EQ(intersect(shape(0.0), {{0.0, 0.0, 10 * mm}, {1.0, 0.0, 0.0}}, 35 * mm).status, LensStatus::missed_lens);
}

TEST_P(Misses, TheFirstOfTwoCrossingsCounts) {
  // Convex towards the eye, R = −30 mm: at the height of −2 mm its half width is √(30² − 28²) = 10.77 mm. A level ray
  // from the left goes in there and would come out at the right; a slightly inclined one does so too.
  const LightRay level{{-20 * mm, 0.0, -2 * mm}, {1.0, 0.0, 0.0}};
  const SurfaceHit hit = intersect(shape(-1.0 / (30 * mm)), level, 25 * mm);
  ASSERT_EQ(hit.status, LensStatus::ok);
  EXPECT_NEAR(hit.position.x(), -10.770329614269007 * mm, 1e-15);
}

TEST(Intersect, ASurfaceThatIsInterruptedBetweenTheEndsOfTheWayIsSearchedInPieces) {
  // A steep sweep (radius 9 mm) with a weak generator of the other sign reaches far along the generator and ends 9 mm
  // from it along the sweep, so an oblique ray finds surface at both ends of its way and none between them. Newton's
  // iteration in the bracket of the whole way met the gap and gave up (no_convergence), although the ray crosses the
  // surface well before it. sturm stress found these.
  struct Case {
    TorusSurface torus;
    double rim_radius;
    LightRay ray;  // surface frame
    Eigen::Vector2d crossing;
  };
  const auto from_eye = [](double vertex_distance, double rotation_center, const Eigen::Vector3d& gaze) -> LightRay {
    return {rotation_center * (gaze + Eigen::Vector3d::UnitZ()) + vertex_distance * Eigen::Vector3d::UnitZ(), gaze};
  };
  const std::vector<Case> cases{
      {TorusSurface(1.0 / (9.639824857228763 * mm), -1.0 / (25.44644772246195 * mm), 122.03920144796109),
       42.09365890485692 * mm,
       from_eye(8.357516212984038 * mm, 15.82838842734457 * mm,
                {-0.2996212720472478, -0.08141222950157229, -0.950578319879205}),
       {-0.007270760723619083, -0.0019755901730133243}},
      {TorusSurface(1.0 / (8.878450371518507 * mm), -1.0 / (29.30803214468138 * mm), 159.62358032518645),
       37.49689547500397 * mm,
       from_eye(9.012128888769553 * mm, 15.601569252738905 * mm,
                {0.4892786924994799, -0.2673701966347581, -0.8301322418852854}),
       {0.012584491677369133, -0.006876894632664263}}};
  for (const Case& c : cases) {
    const SurfaceHit hit = intersect(c.torus, c.ray, c.rim_radius);
    EXPECT_EQ(hit.status, LensStatus::ok);
    if (hit.status != LensStatus::ok) continue;
    EXPECT_LT((hit.position.head<2>() - c.crossing).norm(),
              1e-16);  // the numbers of an extended-precision search; rounding of 42 mm over cos 58°
  }
}

TEST(BracketedRoot, SaysWhenItDoesNotConverge) {
  const auto cube = [](double t) { return std::pair(t * t * t - 2.0, 3.0 * t * t); };
  ASSERT_TRUE(bracketed_root(cube, 0.0, 3.0));
  EXPECT_NEAR(*bracketed_root(cube, 0.0, 3.0), 1.2599210498948732, 1e-15);
  EXPECT_FALSE(bracketed_root(cube, 0.0, 3.0, 3));
  EXPECT_FALSE(bracketed_root([](double) { return std::pair(std::nan(""), 1.0); }, 0.0, 1.0));
}

TEST(BracketedRoot, BisectsWhereTheDerivativeMisleads) {
  const auto flat = [](double t) { return std::pair(std::cbrt(t - 0.3), 1e-9); };
  ASSERT_TRUE(bracketed_root(flat, -1.0, 1.0));
  EXPECT_NEAR(*bracketed_root(flat, -1.0, 1.0), 0.3, 1e-14);
}

}  // namespace
}  // namespace sturm
