// The extended-precision oracle of `sturm stress` against closed forms and other people's numbers, so that what it says about the program
// means something.
#include <gtest/gtest.h>

#include <cmath>

#include "app/stress/oracle.h"
#include "lensmodel/gaze.h"
#include "support/thick_lens_cases.h"

namespace sturm::stress {
namespace {

const Eigen::Vector3d ahead(0.0, 0.0, -1.0);

Eigen::Matrix2d offsets(const ExtendedTrace& t, std::size_t first) {
  Eigen::Matrix2d m;
  m << static_cast<double>(t.offset[0][first]), static_cast<double>(t.offset[0][first + 1]), static_cast<double>(t.offset[1][first]),
      static_cast<double>(t.offset[1][first + 1]);
  return m;
}
Eigen::Matrix2d slopes(const ExtendedTrace& t, std::size_t first) {
  Eigen::Matrix2d m;
  m << static_cast<double>(t.slope[0][first]), static_cast<double>(t.slope[0][first + 1]), static_cast<double>(t.slope[1][first]),
      static_cast<double>(t.slope[1][first + 1]);
  return m;
}

TEST(StressOracle, OneSphereOnItsAxis) {
  // Plano-convex lens of 50 mm radius, index 1.5, flat side to the eye, 2 mm thick, 12 mm away. Paraxial by hand, r[metres]: to the back
  // 0.012, slope 1/1.5 inside, 0.002 of glass; front power (n - 1)/R = 0.5/0.05 = 10 D, converging for light that leaves through it.
  Spectacles lens;
  lens.back = SphereSurface{0.0};
  lens.front = SphereSurface{20.0};
  const ExtendedTrace t = trace_extended(lens, ahead, 13.5e-3, StartingPoints{{0, 0, -0.012}, {0, 0, -0.014}});
  ASSERT_EQ(t.status, LensStatus::ok);
  const double reach = 0.012 + 0.002 / 1.5;
  EXPECT_LT((offsets(t, 0) - Eigen::Matrix2d::Identity()).norm(), 1e-17);
  EXPECT_LT((offsets(t, 2) - reach * Eigen::Matrix2d::Identity()).norm(), 1e-17);  // rounding of the literals
  EXPECT_LT((slopes(t, 0) + 10.0 * Eigen::Matrix2d::Identity()).norm(), 1e-14);    // signed: converging
  EXPECT_LT((slopes(t, 2) - (1.0 - 10.0 * reach) * Eigen::Matrix2d::Identity()).norm(), 1e-15);
}

TEST(StressOracle, ThinCylinderActsAcrossItsSweepMeridian) {
  // A cylinder: curved along the sweep meridian TABO 30, so the power 0.5 * 4 = 2 D acts along the wearer's 150 degrees:
  // u = (-0.866, 0.5), u uᵀ = [[3/4, -0.433], [-0.433, 1/4]]; power of mirrored axes would have +0.433.
  Spectacles lens;
  lens.center_thickness_m = 1e-9;
  lens.vertex_distance_m = 0.0;
  lens.back = SphereSurface{0.0};
  lens.front = TorusSurface(4.0, 0.0, 30.0);
  const ExtendedTrace t = trace_extended(lens, ahead, 0.0, std::nullopt);
  // The back vertex stands in the pupil: no way to it.
  EXPECT_EQ(t.status, LensStatus::missed_lens);
  lens.vertex_distance_m = 1e-9;
  const ExtendedTrace worn = trace_extended(lens, ahead, 0.0, std::nullopt);
  ASSERT_EQ(worn.status, LensStatus::ok);
  Eigen::Matrix2d expected;
  expected << -1.5, 0.8660254037844386, 0.8660254037844386, -0.5;
  EXPECT_LT((slopes(worn, 0) - expected).norm(), 1e-8);  // thin-lens limit: thickness and distance of 1e-9 m times 2 D
}

TEST(StressOracle, ObliquePlaneParallelPlate) {
  // A plate of thickness T shifts and stretches nothing: slopes stay, and the way inside counts as T cos/(n cos'^3) in the plane of
  // incidence, T/(n cos') across it. Gaze 60 degrees to the right: sin 60 = 0.8660254, inside sin = 0.5773503, cos' = 0.8164966.
  Spectacles lens;
  lens.back = lens.front = SphereSurface{0.0};
  lens.diameter_m = 0.2;
  const double s = std::sqrt(0.75), cosine = 0.5, cos_in_glass = std::sqrt(2.0 / 3.0);
  const Eigen::Vector3d gaze(s, 0.0, -cosine);
  const ExtendedTrace t = trace_extended(lens, gaze, 0.0, std::nullopt);
  ASSERT_EQ(t.status, LensStatus::ok);
  const double way = 0.012 / cosine, across = way + 0.002 / (1.5 * cos_in_glass),
               along = way + 0.002 * cosine * cosine / (1.5 * cos_in_glass * cos_in_glass * cos_in_glass);
  EXPECT_NEAR(static_cast<double>(t.offset[0][2]), along, 1e-16);
  EXPECT_NEAR(static_cast<double>(t.offset[1][3]), across, 1e-16);
  EXPECT_LT((slopes(t, 0)).norm(), 1e-17);
  EXPECT_LT((slopes(t, 2) - Eigen::Matrix2d::Identity()).norm(), 1e-15);
  EXPECT_LT((rounded(t.direction) - gaze).norm(), 1e-15);
}

TEST(StressOracle, SteepGlassReflectsTotally) {
  // Back concentric with the centre of rotation: no refraction there; the flat front at 45 degrees is beyond arcsin(1/1.5) = 41.8.
  Spectacles lens;
  lens.back = SphereSurface{1.0 / 25.5e-3};
  lens.front = SphereSurface{0.0};
  lens.diameter_m = 0.1;
  const double r = std::sqrt(0.5);
  EXPECT_EQ(trace_extended(lens, {r, 0.0, -r}, 13.5e-3, std::nullopt).status, LensStatus::total_internal_reflection);
  EXPECT_EQ(trace_extended(lens, {0.6, 0.0, -0.8}, 13.5e-3, std::nullopt).status, LensStatus::ok);  // arcsin 0.6 = 36.9
}

TEST(StressOracle, RimEndsTheLens) {
  Spectacles lens;
  lens.back = lens.front = SphereSurface{0.0};
  lens.diameter_m = 0.024;
  // 45 degrees from the pupil meets the plane 12 mm away at the height 12 mm, the rim's.
  EXPECT_EQ(trace_extended(lens, {std::sqrt(0.5) * 1.001, 0.0, -std::sqrt(1.0 - 0.5 * 1.001 * 1.001)}, 0.0, std::nullopt).status,
            LensStatus::missed_lens);
}

TEST(StressOracle, ThickLensReference) {
  for (const auto& c : testing::thick_lens_cases()) {
    const ExtendedTrace t = trace_extended(c.lens, c.gaze, c.eye.rotation_center_m, std::nullopt);
    ASSERT_EQ(t.status, LensStatus::ok) << c.id;
    EXPECT_LT((rounded(t.exit_point) - testing::ThickLensCase::point(c.json["outputs"]["chief"]["exit_point_mm"])).norm(), 1e-12) << c.id;
    for (const auto& [key, spot] : c.json["outputs"]["spots_4mm"].items()) {
      const double distance = std::stod(key), accommodation = key.ends_with("accommodated") ? 1.0 / distance : 0.0;
      const auto x = t.angular_footprint(c.eye.slope_matrix(accommodation).matrix(), 1.0 / distance);
      const double scale = 0.25 * c.eye.pupil_radius_m * c.eye.pupil_radius_m * distance * distance;
      Eigen::Matrix2d covariance;
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) covariance(i, j) = scale * static_cast<double>(x[i][0] * x[j][0] + x[i][1] * x[j][1]);
      const Eigen::Matrix2d expected = testing::ThickLensCase::symmetric(spot["linear_cov_mm2_xx_xy_yy"], 1e-6);
      EXPECT_LT((covariance - expected).norm(), 1e-8 * expected.norm()) << c.id << " " << key;  // the file's stated accuracy
    }
  }
}

TEST(StressOracle, DerivativesAreThoseOfNeighbouringRays) {
  // The same eye turned a little (about its own pupil) launches the neighbouring ray of slope h: O(h²), h = 1e-6.
  const auto c = testing::thick_lens_cases().at(40);
  const double h = 1e-6;
  const ExtendedTrace t = trace_extended(c.lens, c.gaze, 0.0, std::nullopt);
  ASSERT_EQ(t.status, LensStatus::ok);
  const Frame f = frame_across(extended(c.gaze));
  const auto turned = [&](double by) {
    return trace_extended(c.lens, rounded(normalized(extended(c.gaze) + Extended(by) * f.e1)), 0.0, std::nullopt);
  };
  const ExtendedTrace high = turned(h), low = turned(-h);
  const Vec3<Extended> slope = (0.5L / h) * (high.direction - low.direction);
  EXPECT_NEAR(static_cast<double>(dot(slope, t.frame.e1)), static_cast<double>(t.slope[0][2]), 1e-9);  // 2^-53/h of the rounded gazes
  EXPECT_NEAR(static_cast<double>(dot(slope, t.frame.e2)), static_cast<double>(t.slope[1][2]), 1e-9);
}

}  // namespace
}  // namespace sturm::stress
