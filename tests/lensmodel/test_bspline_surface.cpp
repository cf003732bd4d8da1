#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "lensmodel/bspline_fit.h"
#include "lensmodel/surface.h"
#include "lensmodel/surface_power.h"
#include "support/fixed_rapidcheck_seed.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::mm;

template <class Height>
Eigen::MatrixXd sampled(const KnotGrid& grid, Height&& height) {
  Eigen::MatrixXd z(grid.cells_x + 1, grid.cells_y + 1);
  for (int i = 0; i <= grid.cells_x; ++i)
    for (int j = 0; j <= grid.cells_y; ++j) {
      const Eigen::Vector2d at = grid.first + grid.spacing.cwiseProduct(Eigen::Vector2d(i, j));
      z(i, j) = height(at.x(), at.y());
    }
  return z;
}

BSplineSurface spline_of_sphere(double curvature, double reach, double spacing) {
  const KnotGrid grid = KnotGrid::centred(reach, spacing);
  return BSplineSurface::interpolating(
      grid, sampled(grid, [&](double x, double y) { return SphereSurface{curvature}.sag(x, y)->value; }));
}

/// x³y³ and all below it, without symmetry, of the order of 1; by hand: value and derivatives.
Sag bicubic(double x, double y) {
  const double a = 1 + x - 2 * x * x + 3 * x * x * x, a1 = 1 - 4 * x + 9 * x * x, a2 = -4 + 18 * x;
  const double b = 2 - 3 * y + y * y + 4 * y * y * y, b1 = -3 + 2 * y + 12 * y * y, b2 = 2 + 24 * y;
  Sag s;
  s.value = a * b;
  s.gradient << a1 * b, a * b1;
  s.hessian << a2 * b, a1 * b1, a1 * b1, a * b2;
  return s;
}

const std::vector<KnotGrid> grids{
    {{-1.0, -0.5}, {2.0 / 3, 0.5}, 3, 3}, {{-1.0, -0.5}, {0.5, 0.25}, 4, 5}, {{-0.9, -1.1}, {0.1, 0.2}, 17, 11}};

void expect_bicubic(const BSplineSurface& surface, double tolerance) {
  const Eigen::Vector2d low = surface.grid().first, size = surface.grid().last() - low;
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j) {
      const double x = low.x() + size.x() * (i * 0.9999 + 0.0001) / 20.001,
                   y = low.y() + size.y() * (j * 0.9999 + 0.0001) / 20.001;
      const Sag expected = bicubic(x, y);
      const auto got = surface.sag(x, y);
      ASSERT_TRUE(got);
      EXPECT_NEAR(got->value, expected.value,
                  tolerance * 40);  // the polynomial is at most 40, its derivatives 400, on these grids
      EXPECT_LE((got->gradient - expected.gradient).norm(), tolerance * 400 / surface.grid().spacing.minCoeff());
      EXPECT_LE((got->hessian - expected.hessian).norm(),
                tolerance * 400 / std::pow(surface.grid().spacing.minCoeff(), 2));
    }
}

TEST(BSplineSurface, ReproducesBicubicPolynomialsExactly) {
  for (const KnotGrid& grid : grids)
    expect_bicubic(
        BSplineSurface::interpolating(grid, sampled(grid, [](double x, double y) { return bicubic(x, y).value; })),
        1e-15);
}

TEST(BSplineSurface, AFitReproducesBicubicPolynomialsFromIrregularPoints) {
  for (const KnotGrid& grid : grids) {
    std::vector<Eigen::Vector3d> points;
    const Eigen::Vector2d size = grid.last() - grid.first;
    for (int i = 0; i < 400; ++i) {  // Kronecker's sequence of the plastic number
      const Eigen::Vector2d t(std::fmod(0.5 + i * 0.7548776662466927, 1.0),
                              std::fmod(0.5 + i * 0.5698402909980532, 1.0));
      const Eigen::Vector2d at = grid.first + size.cwiseProduct(t);
      points.emplace_back(at.x(), at.y(), bicubic(at.x(), at.y()).value);
    }
    const BSplineFit fit = fitted_bspline(grid, points);
    EXPECT_LE(fit.residual.max, 40 * 1e-13);
    EXPECT_LE(fit.residual.rms, fit.residual.max);
    expect_bicubic(fit.surface, 1e-11);  // condition of the corners that no point is near
  }
}

RC_GTEST_PROP(BSplineSurface, DerivativesAreThoseOfTheHeight, ()) {
  static const KnotGrid grid{{-1.0, -1.0}, {0.25, 0.2}, 8, 10};
  static const BSplineSurface surface = BSplineSurface::interpolating(
      grid, sampled(grid, [](double x, double y) { return std::sin(3 * x + 1) * std::cos(2 * y - x); }));
  const double x = *rc::gen::inRange(-99, 100) * 0.0098, y = *rc::gen::inRange(-99, 100) * 0.0098, h = 1e-4;
  const auto at = [&](double dx, double dy) { return *surface.sag(x + dx, y + dy); };
  const Sag here = at(0, 0);
  const Eigen::Vector2d gradient((at(h, 0).value - at(-h, 0).value) / (2 * h),
                                 (at(0, h).value - at(0, -h).value) / (2 * h));
  // h²/6 of third derivatives below 100 within a cell; across a knot they jump, which costs half of that again.
  RC_ASSERT((gradient - here.gradient).norm() <= 50 * h * h);
  Eigen::Matrix2d hessian;
  hessian.col(0) = (at(h, 0).gradient - at(-h, 0).gradient) / (2 * h);
  hessian.col(1) = (at(0, h).gradient - at(0, -h).gradient) / (2 * h);
  RC_ASSERT((hessian - here.hessian).norm() <= 100 * h);  // second derivatives have corners at the knots: O(h)
}

/// Largest error of height [m] and curvature [1/m] of the spline through a sphere of radius 50 mm, within 20 mm: ten
/// cells and more from the border, whose influence falls by 0.27 for each.
Eigen::Vector2d errors_on_a_sphere(double spacing) {
  const BSplineSurface spline = spline_of_sphere(20.0, 30 * mm, spacing);
  Eigen::Vector2d worst(0.0, 0.0);
  const int reach =
      static_cast<int>(std::lround(40 * mm / spacing));  // at the knots and between them, where the errors are greatest
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j) {
      const double x = 0.5 * spacing * i, y = 0.5 * spacing * j;
      if (std::hypot(x, y) > 20 * mm) continue;
      const Sag exact = *SphereSurface{20.0}.sag(x, y), got = *spline.sag(x, y);
      worst = worst.cwiseMax(Eigen::Vector2d(std::abs(got.value - exact.value), (got.hessian - exact.hessian).norm()));
    }
  return worst;
}

TEST(BSplineSurface, ConvergesWithTheFourthPowerInHeightAndTheSecondInCurvature) {
  const Eigen::Vector2d coarse = errors_on_a_sphere(1 * mm), middle = errors_on_a_sphere(0.5 * mm),
                        fine = errors_on_a_sphere(0.25 * mm);
  // Asymptotic orders; the next terms are below a tenth.
  EXPECT_NEAR(std::log2(coarse.x() / middle.x()), 4.0, 0.1);
  EXPECT_NEAR(std::log2(middle.x() / fine.x()), 4.0, 0.1);
  EXPECT_NEAR(std::log2(coarse.y() / middle.y()), 2.0, 0.1);
  EXPECT_NEAR(std::log2(middle.y() / fine.y()), 2.0, 0.1);
  // h²/12 of fourth derivatives of 3c³(1 + 4c²r²)/(1 − c²r²)^3.5 ~ 1.5e5 /m³ in each direction.
  EXPECT_LT(fine.y(), 2 * 0.25e-3 * 0.25e-3 / 12 * 1.5e5);
}

TEST(BSplineSurface, EndsAtItsGrid) {
  const BSplineSurface spline = spline_of_sphere(10.0, 10 * mm, 1 * mm);
  EXPECT_TRUE(spline.sag(10 * mm, -10 * mm));
  EXPECT_FALSE(spline.sag(10.001 * mm, 0.0));
  EXPECT_FALSE(spline.sag(0.0, -10.001 * mm));
  EXPECT_FALSE(spline.sag(std::nan(""), 0.0));
}

TEST(BSplineSurface, HeightsAreWithinItsBounds) {
  const BSplineSurface spline = spline_of_sphere(-20.0, 30 * mm, 1 * mm);
  // Lowest in the corners: 50 − √(50² − 2·30²) = 23.542; the outermost coefficient is about the height one
  // knot further out, 50 − √(50² − 2·31²) = 25.96.
  EXPECT_LE(spline.lowest(), -23.5424868893541 * mm);
  EXPECT_GE(spline.lowest(), -25.96 * mm);
  EXPECT_GE(spline.highest(), 0.0);
  EXPECT_LE(spline.highest(), 1e-5);
}

TEST(BSplineSurface, WhatMakesNoSurface) {
  const KnotGrid grid{{0.0, 0.0}, {1.0, 1.0}, 3, 3};
  EXPECT_THROW(BSplineSurface::interpolating(grid, Eigen::MatrixXd::Zero(4, 3)), std::invalid_argument);
  EXPECT_THROW(BSplineSurface::interpolating({{0.0, 0.0}, {1.0, 1.0}, 3, 2}, Eigen::MatrixXd::Zero(4, 3)),
               std::invalid_argument);
  EXPECT_THROW(BSplineSurface::interpolating({{0.0, 0.0}, {1.0, 0.0}, 3, 3}, Eigen::MatrixXd::Zero(4, 4)),
               std::invalid_argument);
  Eigen::MatrixXd hole = Eigen::MatrixXd::Zero(4, 4);
  hole(2, 1) = std::nan("");
  EXPECT_THROW(BSplineSurface::interpolating(grid, hole), std::invalid_argument);
  std::vector<Eigen::Vector3d> line;
  for (int i = 0; i < 30; ++i) line.emplace_back(0.1 * i, 1.0, 0.0);
  EXPECT_THROW(fitted_bspline(grid, line), std::domain_error);
  EXPECT_THROW(fitted_bspline(grid, std::vector<Eigen::Vector3d>(15)), std::domain_error);
  line.emplace_back(3.5, 1.0, 0.0);
  EXPECT_THROW(fitted_bspline(grid, line), std::invalid_argument);
}

RC_GTEST_PROP(BSplineSurface, RaysMeetItWhereTheyMeetTheSphere, ()) {
  static const BSplineSurface splines[] = {spline_of_sphere(-15.0, 36 * mm, 0.5 * mm),
                                           spline_of_sphere(15.0, 36 * mm, 0.5 * mm)};
  const int sign = *rc::gen::element(0, 1);
  const Eigen::Vector3d eye(*rc::gen::inRange(-90, 91) * 0.1 * mm, *rc::gen::inRange(-90, 91) * 0.1 * mm, 25 * mm);
  const LightRay ray{
      eye, Eigen::Vector3d(*rc::gen::inRange(-90, 91) * 0.01, *rc::gen::inRange(-90, 91) * 0.01, -1.0).normalized()};
  const SurfaceHit exact = intersect(SphereSurface{sign ? 15.0 : -15.0}, ray, 35 * mm),
                   got = intersect(splines[sign], ray, 35 * mm);
  RC_PRE(exact.status != LensStatus::ok || exact.position.head<2>().norm() < 34.9 * mm);
  RC_PRE(exact.status != LensStatus::ok || outward_normal(exact.sag).dot(ray.direction) > 0.2);
  RC_ASSERT(got.status == exact.status);
  if (exact.status != LensStatus::ok) return;
  // h⁴/384 of fourth derivatives up to 3c³(1 − c²r²)^−3.5 ~ 1e5 /m³, over cos φ > 0.2.
  RC_ASSERT(std::abs(got.distance - exact.distance) <= 1e-9);
  RC_ASSERT(std::abs(got.sag.value - got.position.z()) <=
            5e-16);  // 16 units in the last place of 40 mm, 1.4e-16, over cos φ
}

TEST(BSplineSurface, RaysThatMiss) {
  const BSplineSurface spline = spline_of_sphere(10.0, 20 * mm, 1 * mm);  // ends before the rim of 35 mm does
  const Eigen::Vector3d outward(0.0, 0.0, -1.0);
  EXPECT_EQ(intersect(spline, {{19 * mm, 0.0, 30 * mm}, outward}, 35 * mm).status, LensStatus::ok);
  EXPECT_EQ(intersect(spline, {{20.001 * mm, 0.0, 30 * mm}, outward}, 35 * mm).status, LensStatus::missed_lens);
  EXPECT_EQ(intersect(spline, {{15.001 * mm, 0.0, 30 * mm}, outward}, 15 * mm).status, LensStatus::missed_lens);
  EXPECT_EQ(intersect(spline, {{0.0, 0.0, -1 * mm}, outward}, 35 * mm).status, LensStatus::missed_lens);  // behind it
  EXPECT_EQ(intersect(spline, {{0.0, 0.0, 10 * mm}, -outward}, 35 * mm).status,
            LensStatus::missed_lens);  // away from it
  EXPECT_EQ(intersect(spline, {{0.0, 0.0, 30 * mm}, {1.0, 0.0, 0.0}}, 35 * mm).status, LensStatus::missed_lens);
  // From below, a level ray enters the bowl from outside first: the wrong side.
  EXPECT_EQ(intersect(spline, {{-30 * mm, 0.0, 0.5 * mm}, {1.0, 0.0, 0.0}}, 15 * mm).status,
            intersect(SphereSurface{10.0}, {{-30 * mm, 0.0, 0.5 * mm}, {1.0, 0.0, 0.0}}, 15 * mm).status);
}

TEST(KnotGrid, CoversItsReachWithAKnotAtTheOrigin) {
  const KnotGrid grid = KnotGrid::centred(10 * mm, 3 * mm);
  EXPECT_EQ(grid.cells_x, 8);
  EXPECT_LE(grid.spacing.x(), 3 * mm);
  EXPECT_GE(grid.last().x(), 10 * mm * (1 - 1e-15));
  EXPECT_NEAR(grid.first.y() + 4 * grid.spacing.y(), 0.0, 1e-18);
}

TEST(SurfacePower, OfSpheresAndCylindersAwayFromTheVertex) {
  const SurfacePower sphere = surface_power(*SphereSurface{20.0}.sag(25 * mm, -14 * mm), 1.5);
  EXPECT_NEAR(sphere.mean_D, 10.0, 1e-14);
  EXPECT_NEAR(sphere.cylinder_D, 0.0, 1e-14);
  // A cylinder of 50 mm: curvatures 20 and 0 wherever one looks. Its axis lies along the wearer's 150°.
  const SurfacePower cylinder = surface_power(*TorusSurface(20.0, 0.0, 30.0).sag(18 * mm, 21 * mm), 1.5);
  EXPECT_NEAR(cylinder.mean_D, 5.0, 1e-14);
  EXPECT_NEAR(cylinder.cylinder_D, 10.0, 1e-14);
  EXPECT_NEAR(surface_power(*SphereSurface{-20.0}.sag(3 * mm, 4 * mm), 1.5).mean_D, -10.0, 1e-14);
}

}  // namespace
}  // namespace sturm
