#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "lensmodel/power_matrix.h"
#include "support/fixed_rapidcheck_seed.h"

namespace sturm {
namespace {

/// Quarter dioptres and whole degrees, as prescriptions are written; every number is exact in binary.
Prescription any_prescription() {
  return {*rc::gen::inRange(-80, 81) * 0.25, *rc::gen::inRange(-40, 41) * 0.25,
          static_cast<double>(*rc::gen::inRange(0, 181)), 0.0};
}

RC_GTEST_PROP(Prescription, TranspositionIsTheSameLens, ()) {
  const Prescription rx = any_prescription();
  const PowerMatrix a = PowerMatrix::from(rx), b = PowerMatrix::from(transposed(rx));
  // Four roundings at 30 D, unit 3.6e-15 D.
  RC_ASSERT((a.matrix() - b.matrix()).cwiseAbs().maxCoeff() <= 2e-14);
}

RC_GTEST_PROP(Prescription, TransposingTwiceGivesTheSameNumbers, ()) {
  const Prescription rx = any_prescription(), twice = transposed(transposed(rx));
  RC_ASSERT(twice.sphere_D == rx.sphere_D);
  RC_ASSERT(twice.cylinder_D == rx.cylinder_D);
  RC_ASSERT(twice.axis_deg == (rx.axis_deg == 0.0 ? 180.0 : rx.axis_deg));
}

RC_GTEST_PROP(Prescription, MinusCylinderFormIsTheSameLens, ()) {
  const Prescription rx = any_prescription(), minus = in_minus_cylinder_form(rx);
  RC_ASSERT(minus.cylinder_D <= 0.0);
  RC_ASSERT(minus.axis_deg > 0.0 && minus.axis_deg <= 180.0);
  RC_ASSERT((PowerMatrix::from(rx).matrix() - PowerMatrix::from(minus).matrix()).cwiseAbs().maxCoeff() <= 2e-14);
}

TEST(Prescription, TranspositionByHand) {
  // +1.00 −2.00 × 30 is −1.00 +2.00 × 120.
  const Prescription plus = transposed({1.0, -2.0, 30.0, 0.012});
  EXPECT_EQ(plus.sphere_D, -1.0);
  EXPECT_EQ(plus.cylinder_D, 2.0);
  EXPECT_EQ(plus.axis_deg, 120.0);
  EXPECT_EQ(plus.vertex_distance_m, 0.012);
  EXPECT_EQ(transposed({0.0, 1.0, 135.0, 0.0}).axis_deg, 45.0);
  EXPECT_EQ(transposed({0.0, 1.0, 90.0, 0.0}).axis_deg, 180.0);
}

TEST(Prescription, AxisFoldsIntoItsNotation) {
  EXPECT_EQ(folded_axis_deg(0.0), 180.0);
  EXPECT_EQ(folded_axis_deg(180.0), 180.0);
  EXPECT_EQ(folded_axis_deg(-30.0), 150.0);
  EXPECT_EQ(folded_axis_deg(210.0), 30.0);
  EXPECT_EQ(folded_axis_deg(-180.0), 180.0);
  EXPECT_EQ(folded_axis_deg(1e-9), 1e-9);
}

TEST(Prescription, WithoutCylinderTheAxisIsWritten180) {
  EXPECT_EQ(in_minus_cylinder_form({-3.0, 0.0, 77.0, 0.0}).axis_deg, 180.0);
}

TEST(Prescription, RangesAreInclusive) {
  EXPECT_NO_THROW(validate({-40.0, 40.0, 0.0, 0.0}));
  EXPECT_NO_THROW(validate({40.0, -40.0, 180.0, 0.05}));
}

TEST(Prescription, OutOfRangeOrNotANumberIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  for (const Prescription& rx : {Prescription{40.01, 0, 180, 0},
                                 {-40.01, 0, 180, 0},
                                 {0, 40.01, 180, 0},
                                 {0, -40.01, 180, 0},
                                 {0, -1, -0.01, 0},
                                 {0, -1, 180.01, 0},
                                 {0, 0, 180, -1e-6},
                                 {0, 0, 180, 0.0501},
                                 {nan, 0, 180, 0},
                                 {0, nan, 180, 0},
                                 {0, 0, nan, 0},
                                 {0, 0, 180, nan},
                                 {infinite, 0, 180, 0},
                                 {0, -infinite, 180, 0}})
    EXPECT_THROW(validate(rx), std::invalid_argument)
        << rx.sphere_D << " " << rx.cylinder_D << " " << rx.axis_deg << " " << rx.vertex_distance_m;
}

}  // namespace
}  // namespace sturm
