// may_meet is a bound: it may let a ray through that misses, and never stops one that meets the surface.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "lensmodel/surface.h"
#include "support/drawn.h"
#include "support/fixed_rapidcheck_seed.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::drawn;
using testing::mm;

/// Radii of curvature down to 25 mm of either sign, so that some surfaces end before a rim of 35 mm.
Surface any_short_surface() {
  const double c = drawn(-40, 40, 1.0), other = drawn(-40, 40, 1.0);
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return SphereSurface{c};
    case 1:
      return TorusSurface(c, other, drawn(0, 180, 1.0));
    case 2:
      return ConicSurface{c, drawn(-30, 10, 0.1)};
    default: {
      const KnotGrid grid = KnotGrid::centred(36 * mm, 4 * mm);
      Eigen::MatrixXd heights(grid.cells_x + 1, grid.cells_y + 1);
      for (int i = 0; i <= grid.cells_x; ++i)
        for (int j = 0; j <= grid.cells_y; ++j) {
          const Eigen::Vector2d p = grid.first + grid.spacing.cwiseProduct(Eigen::Vector2d(i, j));
          heights(i, j) = 0.2 * (c * p.x() * p.x() + other * p.y() * p.y());
        }
      return BSplineSurface::interpolating(grid, heights);
    }
  }
}

RC_GTEST_PROP(MayMeet, EveryRayThatMeetsTheSurface, ()) {
  const Surface surface = any_short_surface();
  // Most of them at the rim, where the bounds are tight.
  const double rim = drawn(150, 350, 0.1 * mm), r = rim * (1.0 - std::pow(drawn(0, 100, 0.01), 4.0)),
               angle = drawn(0, 359, M_PI / 180.0);
  const auto there = sag(surface, r * std::cos(angle), r * std::sin(angle));
  RC_PRE(there.has_value());
  const Eigen::Vector3d target(r * std::cos(angle), r * std::sin(angle), there->value);
  // From anywhere on the eye's side: also nearly parallel to the axis, and from beyond the rim.
  const Eigen::Vector3d eye(drawn(-500, 500, 0.1 * mm), drawn(-500, 500, 0.1 * mm),
                            there->value + drawn(1, 500, 0.1 * mm));
  const LightRay ray{eye, (target - eye).normalized()};
  RC_PRE(intersect(surface, ray, rim).status == LensStatus::ok);
  RC_ASSERT(may_meet(surface, ray, rim));
}

TEST(MayMeet, ARayThroughTheRimOfASphereOfEitherSign) {
  // R = ±50 mm rises by ±10 mm at 30 mm. Aimed at the rim from the axis, the ray leaves the rim's cylinder there.
  for (const double sign : {1.0, -1.0}) {
    const Eigen::Vector3d eye(0.0, 0.0, 25 * mm), target(29.9999 * mm, 0.0, sign * 9.9999 * mm);
    const LightRay ray{eye, (target - eye).normalized()};
    EXPECT_EQ(intersect(SphereSurface{sign * 20.0}, ray, 30 * mm).status, LensStatus::ok) << sign;
    EXPECT_TRUE(may_meet(SphereSurface{sign * 20.0}, ray, 30 * mm)) << sign;
  }
}

TEST(MayMeet, StopsARayThatPassesOutsideOfTheRim) {
  const LightRay past{{0.0, 0.0, 25 * mm},
                      Eigen::Vector3d(35.0, 0.0, -15.0).normalized()};  // at 35 mm where the rim is at 30 mm
  EXPECT_FALSE(may_meet(SphereSurface{20.0}, past, 30 * mm));
}

}  // namespace
}  // namespace sturm
