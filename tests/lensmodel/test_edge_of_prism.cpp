// The rim of a prism is thickest at its base and thinnest opposite to it: only a search over the whole turn finds both.
#include <gtest/gtest.h>

#include "lensmodel/edge_thickness.h"
#include "lensmodel/prism.h"

namespace sturm {
namespace {

struct Base {
  double base_deg;
  Eigen::Vector2d direction;  // wearer frame: 0 is the wearer's left, 90 up
};

TEST(EdgeThickness, OfAPrismWhateverItsBase) {
  // Plane surfaces, n = 1.5, 5 Δ. Out along the axis to a back surface that leans by θ: inside the ray leans by δ = θ −
  // asin(sin θ/n), outside by asin(n sin δ), whose tangent is 0.05 for tan θ = 0.10004…
  const double slope = 0.10004160019801485, radius = 20e-3, middle = 4e-3;
  Spectacles plane;
  plane.center_thickness_m = middle;
  plane.diameter_m = 2.0 * radius;
  for (const Base& base : {Base{0.0, {-1.0, 0.0}}, Base{90.0, {0.0, 1.0}}, Base{180.0, {1.0, 0.0}},
                           Base{270.0, {0.0, -1.0}}, Base{217.0, {0.79863551004729284, -0.60181502315204827}}}) {
    const Spectacles prism = with_prism(plane, 5.0, base.base_deg);
    const EdgeThickness edge = edge_thickness(prism);
    ASSERT_EQ(edge.status, EdgeStatus::ok) << base.base_deg;
    // The wedge is good to 1e-14; the search ends where the thickness is flat to rounding.
    EXPECT_NEAR(edge.rim->max, middle + slope * radius, 1e-15) << base.base_deg;
    EXPECT_NEAR(edge.rim->min, middle - slope * radius, 1e-15) << base.base_deg;
    // The back surface rises towards the eye on the side of the base.
    EXPECT_LT((prism.mounting.wedge() - slope * base.direction).norm(), 1e-13) << base.base_deg;
  }
}

}  // namespace
}  // namespace sturm
