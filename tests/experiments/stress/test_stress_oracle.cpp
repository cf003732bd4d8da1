// The extended-precision oracle of `sturm stress` against closed forms and other people's numbers, so that what it says
// about the program means something.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/stress/oracle.h"
#include "lensmodel/gaze.h"
#include "support/thick_lens_cases.h"

namespace sturm::stress {
namespace {

const Eigen::Vector3d ahead(0.0, 0.0, -1.0);

Eigen::Matrix2d offsets(const ExtendedTrace& t, std::size_t first) {
  Eigen::Matrix2d m;
  m << static_cast<double>(t.offset[0][first]), static_cast<double>(t.offset[0][first + 1]),
      static_cast<double>(t.offset[1][first]), static_cast<double>(t.offset[1][first + 1]);
  return m;
}
Eigen::Matrix2d slopes(const ExtendedTrace& t, std::size_t first) {
  Eigen::Matrix2d m;
  m << static_cast<double>(t.slope[0][first]), static_cast<double>(t.slope[0][first + 1]),
      static_cast<double>(t.slope[1][first]), static_cast<double>(t.slope[1][first + 1]);
  return m;
}

TEST(StressOracle, OneSphereOnItsAxis) {
  // Plano-convex lens of 50 mm radius, index 1.5, flat side to the eye, 2 mm thick, 12 mm away. Paraxial by hand,
  // r[metres]: to the back 0.012, slope 1/1.5 inside, 0.002 of glass; front power (n - 1)/R = 0.5/0.05 = 10 D,
  // converging for light that leaves through it.
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
  // A cylinder: curved along the sweep meridian TABO 30, so the power 0.5 * 4 = 2 D acts along the wearer's 150
  // degrees: u = (-0.866, 0.5), u uᵀ = [[3/4, -0.433], [-0.433, 1/4]]; power of mirrored axes would have +0.433.
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
  // A plate of thickness T shifts and stretches nothing: slopes stay, and the way inside counts as T cos/(n cos'^3) in
  // the plane of incidence, T/(n cos') across it. Gaze 60 degrees to the right: sin 60 = 0.8660254, inside sin =
  // 0.5773503, cos' = 0.8164966.
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
  // Back concentric with the centre of rotation: no refraction there; the flat front at 45 degrees is beyond
  // arcsin(1/1.5) = 41.8.
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
  EXPECT_EQ(
      trace_extended(lens, {std::sqrt(0.5) * 1.001, 0.0, -std::sqrt(1.0 - 0.5 * 1.001 * 1.001)}, 0.0, std::nullopt)
          .status,
      LensStatus::missed_lens);
}

TEST(StressOracle, AWrappedPlateShiftsTheRayToTheSideThatIsNearer) {
  // Incidence of 60 degrees as above, but the plate stands oblique. Its outward normal leans to the right, (0.866, 0,
  // -0.5), so does the ray inside: by gamma sin 60 a unit of way, gamma = cos' - cos/1.5. A pantoscopic tilt does the
  // same downwards.
  Spectacles lens;
  lens.back = lens.front = SphereSurface{0.0};
  const double angle = std::acos(0.5), cos_in_glass = std::sqrt(2.0 / 3.0), way = 0.002 / cos_in_glass;
  const double shift = way * (cos_in_glass - 0.5 / 1.5) * std::sqrt(0.75);
  const double along = 0.012 + 0.002 * 0.25 / (1.5 * cos_in_glass * cos_in_glass * cos_in_glass),
               across = 0.012 + way / 1.5;
  lens.mounting = Mounting(Eigen::Vector2d::Zero(), 0.0, angle);
  const ExtendedTrace wrapped = trace_extended(lens, ahead, 13.5e-3, std::nullopt);
  ASSERT_EQ(wrapped.status, LensStatus::ok);
  EXPECT_LT((rounded(wrapped.exit_point).head<2>() - Eigen::Vector2d(shift, 0.0)).norm(), 1e-17);
  EXPECT_NEAR(static_cast<double>(wrapped.offset[0][2]), along, 1e-16);
  EXPECT_NEAR(static_cast<double>(wrapped.offset[1][3]), across, 1e-16);
  lens.mounting = Mounting(Eigen::Vector2d::Zero(), angle, 0.0);
  const ExtendedTrace tilted = trace_extended(lens, ahead, 13.5e-3, std::nullopt);
  ASSERT_EQ(tilted.status, LensStatus::ok);
  EXPECT_LT((rounded(tilted.exit_point).head<2>() - Eigen::Vector2d(0.0, -shift)).norm(), 1e-17);
  EXPECT_NEAR(static_cast<double>(tilted.offset[1][3]), along, 1e-16);
  EXPECT_LT((rounded(tilted.direction) - ahead).norm(), 1e-16);
}

TEST(StressOracle, FirstTheTiltThenTheWrap) {
  // By 3-4-5 angles: the axis (0, 0, -1) tilts to (0, -0.6, -0.8), and the wrap
  // about the vertical takes that to (0.48, -0.6, -0.64). The other way round it would be (0.6, -0.48, -0.64). A ray
  // along the axis through the back vertex goes straight on.
  Spectacles lens;
  lens.back = lens.front = SphereSurface{4.0};
  const Eigen::Vector3d axis(0.48, -0.6, -0.64);
  lens.mounting = Mounting(0.02 * axis.head<2>(), std::asin(0.6), std::asin(0.6));
  lens.vertex_distance_m = 0.02 * 0.64;
  const ExtendedTrace t = trace_extended(lens, axis, 0.0, std::nullopt);
  ASSERT_EQ(t.status, LensStatus::ok);
  EXPECT_LT((rounded(t.direction) - axis).norm(), 1e-15);  // rounding of the angles
  EXPECT_LT((rounded(t.exit_point) - 0.022 * axis).norm(), 1e-16);
}

TEST(StressOracle, AWedgeIsAPrism) {
  // Back plane leaning by 30 degrees towards the right (z = x tan 30), front plane straight: inside sin 30/1.5 = 1/3,
  // so 30 - asin(1/3) from the axis, and Snell's law at the front: sin out = 1.5 sin of that, to the right. The back
  // vertex stands 1 mm to the right.
  Spectacles lens;
  lens.back = lens.front = SphereSurface{0.0};
  const double slope = std::sqrt(1.0 / 3.0);
  lens.mounting = Mounting({1e-3, 2e-3}, 0.0, 0.0).with_wedge({slope, 0.0});
  const ExtendedTrace t = trace_extended(lens, ahead, 13.5e-3, std::nullopt);
  ASSERT_EQ(t.status, LensStatus::ok);
  EXPECT_NEAR(t.at[0].path_m, 12e-3 + 1e-3 * slope, 1e-17);
  EXPECT_NEAR(static_cast<double>(t.direction.x), 1.5 * std::sin(std::asin(0.5) - std::asin(1.0 / 3.0)), 1e-15);
  EXPECT_EQ(static_cast<double>(t.direction.y), 0.0);
  EXPECT_EQ(static_cast<double>(t.exit_point.y), 0.0);
}

TEST(StressOracle, ASplineThroughAParaboloidIsTheParaboloid) {
  // Bicubic splines hold it exactly, but for the rounding of the coefficients C: 2^-53 C (16 + 16 + 2·2.25²)^½/h² in a
  // curvature, with C = 1.3e-2, h = 5e-3, 4e-13; times n − 1.
  Spectacles lens;
  lens.back = ConicSurface{10.0, -1.0};
  lens.front = TorusSurface(5.0, 3.0, 30.0);
  Spectacles spline = lens;
  const KnotGrid grid = KnotGrid::centred(35e-3, 5e-3);
  Eigen::MatrixXd heights(grid.cells_x + 1, grid.cells_y + 1);
  for (int i = 0; i <= grid.cells_x; ++i)
    for (int j = 0; j <= grid.cells_y; ++j)
      heights(i, j) = 5.0 * (grid.first + grid.spacing.cwiseProduct(Eigen::Vector2d(i, j))).squaredNorm();
  spline.back = BSplineSurface::interpolating(grid, heights);
  const Eigen::Vector3d gaze = Eigen::Vector3d(0.4, -0.3, -1.0).normalized();
  const ExtendedTrace exact = trace_extended(lens, gaze, 13.5e-3, std::nullopt),
                      t = trace_extended(spline, gaze, 13.5e-3, std::nullopt);
  ASSERT_EQ(exact.status, LensStatus::ok);
  ASSERT_EQ(t.status, LensStatus::ok);
  EXPECT_LT((rounded(t.exit_point) - rounded(exact.exit_point)).norm(), 1e-16);
  EXPECT_LT((offsets(t, 2) - offsets(exact, 2)).norm(), 1e-14);
  EXPECT_LT((slopes(t, 0) - slopes(exact, 0)).norm(), 4e-13);
  EXPECT_GT(slopes(exact, 0).norm(), 1.0);
  EXPECT_NEAR(t.at[0].shape.hessian, 10.0 * std::sqrt(2.0), 1e-12);
  EXPECT_LT(t.at[0].shape.hessian_change, 1e-6);  // third derivatives from rounded coefficients: 4e-13 on 5e-3
}

TEST(StressOracle, ThickLensReference) {
  for (const auto& c : testing::thick_lens_cases()) {
    const ExtendedTrace t = trace_extended(c.lens, c.gaze, c.eye.rotation_center_m, std::nullopt);
    ASSERT_EQ(t.status, LensStatus::ok) << c.id;
    EXPECT_LT(
        (rounded(t.exit_point) - testing::ThickLensCase::point(c.json["outputs"]["chief"]["exit_point_mm"])).norm(),
        1e-12)
        << c.id;
    for (const auto& [key, spot] : c.json["outputs"]["spots_4mm"].items()) {
      const double distance = std::stod(key), accommodation = key.ends_with("accommodated") ? 1.0 / distance : 0.0;
      const auto x = t.angular_footprint(c.eye.slope_matrix(accommodation).matrix(), 1.0 / distance);
      const double scale = 0.25 * c.eye.pupil_radius_m * c.eye.pupil_radius_m * distance * distance;
      Eigen::Matrix2d covariance;
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
          covariance(i, j) = scale * static_cast<double>(x[i][0] * x[j][0] + x[i][1] * x[j][1]);
      const Eigen::Matrix2d expected = testing::ThickLensCase::symmetric(spot["linear_cov_mm2_xx_xy_yy"], 1e-6);
      EXPECT_LT((covariance - expected).norm(), 1e-8 * expected.norm())
          << c.id << " " << key;  // the file's stated accuracy
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
  EXPECT_NEAR(static_cast<double>(dot(slope, t.frame.e1)), static_cast<double>(t.slope[0][2]),
              1e-9);  // 2^-53/h of the rounded gazes
  EXPECT_NEAR(static_cast<double>(dot(slope, t.frame.e2)), static_cast<double>(t.slope[1][2]), 1e-9);
}

}  // namespace
}  // namespace sturm::stress
