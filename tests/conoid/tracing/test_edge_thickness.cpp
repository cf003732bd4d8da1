// Edge thickness against sagittas worked by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "lensmodel/edge_thickness.h"

namespace sturm {
namespace {

Spectacles lens_of(const Surface& front, const Surface& back, double thickness_m, double diameter_m) {
  Spectacles lens;
  lens.front = front;
  lens.back = back;
  lens.center_thickness_m = thickness_m;
  lens.diameter_m = diameter_m;
  return lens;
}

TEST(EdgeThickness, OfAMinusMeniscus) {
  // Radii 250 and 65 mm at 25 mm: sagittas 250 − √(250² − 25²) = 1.2531407 and 65 − 60 = 5 mm.
  const EdgeThickness edge = edge_thickness(lens_of(SphereSurface{4.0}, SphereSurface{1.0 / 0.065}, 2e-3, 50e-3));
  EXPECT_EQ(edge.status, EdgeStatus::ok);
  EXPECT_NEAR(edge.rim->min, 7e-3 - (0.25 - std::sqrt(0.061875)), 1e-16);
  EXPECT_NEAR(edge.rim->max, edge.rim->min, 1e-16);
  EXPECT_EQ(edge.usable_diameter_m, 50e-3);
}

TEST(EdgeThickness, ThinnestAndThickestPlaceOfATorus) {
  // Flat front; a back with the radii 65 mm (sagitta 5 mm at 25 mm) and 0, at an AXIS that no whole degree of the
  // search hits.
  for (const double axis : {0.0, 37.123, 90.0, 151.77}) {
    const EdgeThickness edge =
        edge_thickness(lens_of(SphereSurface{}, TorusSurface(1.0 / 0.065, 0.0, axis), 1e-3, 50e-3));
    EXPECT_EQ(edge.status, EdgeStatus::ok);
    EXPECT_NEAR(edge.rim->min, 1e-3, 1e-15) << axis;
    EXPECT_NEAR(edge.rim->max, 6e-3, 1e-15) << axis;
  }
}

TEST(EdgeThickness, SurfacesThatCross) {
  // Plano-convex, radius 65 mm: 3 mm are used up where 65 − √(65² − r²) = 3, r² = 65² − 62² = 381 mm².
  const EdgeThickness edge = edge_thickness(lens_of(SphereSurface{1.0 / 0.065}, SphereSurface{}, 3e-3, 50e-3));
  EXPECT_EQ(edge.status, EdgeStatus::surfaces_cross);
  EXPECT_FALSE(edge.rim);
  EXPECT_NEAR(edge.usable_diameter_m, 2e-3 * std::sqrt(381.0), 1e-14);
  // Smaller than that it has an edge.
  EXPECT_EQ(edge_thickness(lens_of(SphereSurface{1.0 / 0.065}, SphereSurface{}, 3e-3, 39e-3)).status, EdgeStatus::ok);
}

TEST(EdgeThickness, SurfacesThatCrossAndCrossBack) {
  // Front paraboloid r²/50 mm, back sphere of 30 mm, which is r²/60 mm near the axis and the deeper of the two towards
  // its equator: at 20 mm 0.1 + (30 − √500) − 8 = −0.26 mm, at the rim 9.8 mm.
  const auto lens = lens_of(ConicSurface{1.0 / 0.025, -1.0}, SphereSurface{1.0 / 0.030}, 0.1e-3, 59.8e-3);
  const double at_rim = 0.1 + (30.0 - std::sqrt(900.0 - 29.9 * 29.9)) - 29.9 * 29.9 / 50.0;
  EXPECT_GT(at_rim, 0.0);
  const EdgeThickness edge = edge_thickness(lens);
  EXPECT_EQ(edge.status, EdgeStatus::surfaces_cross);
  EXPECT_FALSE(edge.rim);
}

TEST(EdgeThickness, SurfacesThatEndBeforeTheRim) {
  const EdgeThickness edge = edge_thickness(lens_of(SphereSurface{}, SphereSurface{1.0 / 0.02}, 2e-3, 50e-3));
  EXPECT_EQ(edge.status, EdgeStatus::surface_ends);
  EXPECT_NEAR(edge.usable_diameter_m, 40e-3, 1e-14);
}

}  // namespace
}  // namespace sturm
