#include <gtest/gtest.h>

#include <limits>

#include "lensmodel/focal_lines.h"
#include "lensmodel/power_matrix.h"
#include "lensmodel/tabo.h"

namespace sturm {
namespace {

Eigen::Matrix2d relaxed_wave(const Prescription& rx) {
  return -power_at_cornea(rx).matrix();
}

// PL −2.00 × 30 at the cornea: no power along TABO 30, which is the wearer's 150°, and −2 D across it, along the
// wearer's 60°. Far points are spread along 60°, so far lines along 60° are sharp; at half a metre it is the other way
// round. Literals, and an oblique axis: 90 and 180 are their own mirror images.
TEST(FocalLines, SimpleMyopicAstigmatWithAnObliqueAxis) {
  const auto lines = focal_lines(relaxed_wave({0.0, -2.0, 30.0, 0.0}));
  EXPECT_NEAR(lines[0].vergence_D, 2.0, 1e-14);
  EXPECT_NEAR(*lines[0].distance_m(), 0.5, 1e-14);
  EXPECT_NEAR(*lines[0].direction_deg, -30.0, 1e-12);  // 150°
  EXPECT_NEAR(lines[1].vergence_D, 0.0, 1e-14);
  EXPECT_NEAR(*lines[1].direction_deg, 60.0, 1e-12);
  EXPECT_NEAR(tabo_deg(*lines[0].direction_deg), 30.0, 1e-12);
  EXPECT_NEAR(tabo_deg(*lines[1].direction_deg), 120.0, 1e-12);
}

TEST(FocalLines, TheOtherObliqueAxisIsTheMirrorImage) {
  const auto lines = focal_lines(relaxed_wave({0.0, -2.0, 150.0, 0.0}));
  EXPECT_NEAR(*lines[0].direction_deg, 30.0, 1e-12);
  EXPECT_NEAR(*lines[1].direction_deg, -60.0, 1e-12);
}

TEST(FocalLines, WithoutCylinderThereIsAPoint) {
  for (const FocalLine& line : focal_lines(relaxed_wave({-4.0, 0.0, 30.0, 0.0}))) {
    EXPECT_EQ(*line.distance_m(), 0.25);
    EXPECT_FALSE(line.direction_deg);
  }
}

TEST(FocalLines, HyperopesHaveNoneAhead) {
  const auto lines = focal_lines(relaxed_wave({1.0, 0.0, 180.0, 0.0}));
  EXPECT_EQ(lines[0].vergence_D, -1.0);
  EXPECT_FALSE(lines[0].distance_m());
  EXPECT_EQ(focal_lines(Eigen::Matrix2d::Zero())[0].distance_m(), std::numeric_limits<double>::infinity());
}

TEST(Tabo, FoldsIntoZeroTo180) {
  EXPECT_EQ(tabo_deg(0.0), 180.0);
  EXPECT_EQ(tabo_deg(90.0), 90.0);
  EXPECT_EQ(tabo_deg(-30.0), 30.0);
  EXPECT_EQ(tabo_deg(60.0), 120.0);
}

}  // namespace
}  // namespace sturm
