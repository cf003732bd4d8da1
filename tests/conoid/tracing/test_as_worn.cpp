// As-worn powers against tests/reference/thick_lens.json (other people's programs), and against real rays where the
// file has no case.
#include <gtest/gtest.h>

#include <cmath>

#include "conoid/tracing/as_worn.h"
#include "lensmodel/gaze.h"
#include "lensmodel/single_vision.h"
#include "lensmodel/vertex_power.h"
#include "support/thick_lens_cases.h"

namespace sturm {
namespace {

using nlohmann::json;
using testing::ThickLensCase;

const Eigen::Vector3d ahead(0.0, 0.0, -1.0);

double largest(const Eigen::Matrix2d& m) {
  return m.cwiseAbs().maxCoeff();
}

TEST(AsWornReference, PowersErrorsAndDeviations) {
  const auto cases = testing::thick_lens_cases();
  ASSERT_EQ(cases.size(), 117u);
  for (const ThickLensCase& c : cases) {
    const json& out = c.json["outputs"];
    const AsWorn worn = as_worn(c.lens, c.gaze, c.eye.rotation_center_m);
    ASSERT_EQ(worn.status, LensStatus::ok) << c.id;
    ASSERT_TRUE(worn.power) << c.id;
    // The file's own two ways to this number agree to 7e-12 D.
    EXPECT_LT(largest(worn.power->matrix() - ThickLensCase::symmetric(out["as_worn_power_D_xx_xy_yy"])), 1e-8) << c.id;
    // The file prints arc cosines, which lose half of the digits near 0: 2e-8 rad there.
    EXPECT_NEAR(worn.deviation_rad * 57.29577951308232, out["deviation_deg"].get<double>(), 2e-6) << c.id;
  }
}

TEST(AsWornReference, BackVertexPowersAreThePrescriptions) {
  for (const ThickLensCase& c : testing::thick_lens_cases()) {
    const json& rx = c.json["inputs"]["Rx"];
    const auto power = vertex_power(c.lens).back_vertex;
    ASSERT_TRUE(power) << c.id;
    // In the examiner's frame the cylinder acts at AXIS + 90°: xx = S + C sin², xy = −C sin cos, yy = S + C cos².
    const double s = rx["S"].get<double>(), cylinder = rx["C"].get<double>(),
                 axis = rx["A"].get<double>() * 0.017453292519943295;
    Eigen::Matrix2d expected;
    const double wearer_xy = cylinder * std::sin(axis) * std::cos(axis);
    expected << s + cylinder * std::sin(axis) * std::sin(axis), wearer_xy, wearer_xy,
        s + cylinder * std::cos(axis) * std::cos(axis);
    // The file says 4.9e-15 D for its own lenses.
    EXPECT_LT(largest(power->matrix() - expected), 1e-12) << c.id;
  }
}

TEST(VertexPower, CrossedToricSurfaces) {
  // Plano-convex cylinders, n = 1.5: front +5 D across AXIS 180 (power in y), back −2 D across AXIS 45 of the examiner,
  // 135° of the wearer.
  Spectacles lens;
  lens.front = TorusSurface(0.0, 10.0, 180.0);
  lens.back = TorusSurface(0.0, 4.0, 45.0);
  lens.center_thickness_m = 3e-3;
  const VertexPower power = vertex_power(lens);
  EXPECT_LT(largest(power.front.matrix() - (Eigen::Matrix2d() << 0.0, 0.0, 0.0, 5.0).finished()), 1e-15);
  EXPECT_LT(largest(power.back.matrix() - (Eigen::Matrix2d() << -1.0, -1.0, -1.0, -1.0).finished()), 1e-15);
  // 5/(1 − 0.003/1.5 · 5) = 5.0505…
  EXPECT_LT(
      largest(power.back_vertex->matrix() - (Eigen::Matrix2d() << -1.0, -1.0, -1.0, 4.05050505050505050).finished()),
      1e-14);
}

TEST(VertexPower, NoneWhereTheFrontsFocusLiesInTheBackVertex) {
  Spectacles lens;
  lens.front = SphereSurface{1000.0};  // +500 D in n = 1.5: its focus lies 3 mm behind it in the glass
  lens.center_thickness_m = 3e-3;
  EXPECT_FALSE(vertex_power(lens).back_vertex);
}

TEST(AsWorn, OnTheAxisItIsTheBackVertexPower) {
  SingleVisionDesign design;
  design.vertex_distance_m = 15e-3;
  const Spectacles lens = single_vision({3.0, -2.0, 30.0}, design);
  const AsWorn worn = as_worn(lens, ahead, 13.5e-3);
  EXPECT_EQ(worn.deviation_rad, 0.0);
  EXPECT_EQ(worn.prism_cm_per_m(), 0.0);
  EXPECT_FALSE(worn.base_deg);
  // 3 − 2 sin² 30°, −2 sin 30° cos 30° (wearer's sign), 3 − 2 cos² 30°
  EXPECT_LT(largest(worn.power->matrix() -
                    (Eigen::Matrix2d() << 2.5, -0.8660254037844386, -0.8660254037844386, 1.5).finished()),
            1e-13);
}

// Rays launched from the vertex sphere with the as-worn power as slopes leave the lens parallel. A conic front, another
// index, another vertex distance than the file's 12 mm.
TEST(AsWorn, RealRaysLeaveParallel) {
  Spectacles lens;
  lens.front = ConicSurface{1.0 / 0.09, -1.4};
  lens.back = TorusSurface(1.0 / 0.2, 1.0 / 0.13, 70.0);
  lens.center_thickness_m = 5e-3;
  lens.refractive_index = 1.67;
  lens.vertex_distance_m = 16e-3;
  const double center = 14e-3;
  const Eigen::Vector3d gaze = gaze_direction(0.45, -0.3);
  const AsWorn worn = as_worn(lens, gaze, center);
  ASSERT_TRUE(worn.power);
  const Eigen::Matrix3d turn = smallest_rotation(ahead, gaze);
  const Eigen::Vector3d vertex = turned_pupil_center(gaze, center) + lens.vertex_distance_m * gaze;
  const auto exit = [&](const Eigen::Vector2d& p) {
    const Eigen::Vector2d slope = worn.power->slope(p);
    const Eigen::Vector3d direction = (turn * Eigen::Vector3d(slope.x(), slope.y(), -1.0)).normalized();
    // Launched 10 mm behind the sphere, from where every ray is still before the lens.
    const LensPath path =
        trace(lens, {vertex + turn * Eigen::Vector3d(p.x(), p.y(), 0.0) - 10e-3 * direction, direction});
    EXPECT_EQ(path.status, LensStatus::ok);
    return path.exit.direction;
  };
  const double h = 1e-5;
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(h, 0.0), Eigen::Vector2d(0.0, h)})
    // Third-order aberration: O(h²) of some 1e4 D/m², 1e-6 D; rounding 1e-16/h = 1e-11 D.
    EXPECT_LT((exit(p) - exit(-p)).norm() / (2.0 * h), 1e-5);
}

TEST(AsWorn, PrismBasesOfAPlusLens) {
  // Of a plus lens the base is its middle: looking to the right, up and right-down its base is to the left (examiner's
  // right, 0°), down (270°) and left-up (45°).
  const Spectacles lens = single_vision({5.0, 0.0, 180.0}, {.base_curve_D = 4.0});
  const auto base = [&](double azimuth, double elevation) {
    return as_worn(lens, gaze_direction(azimuth, elevation), 13.5e-3).base_deg.value();
  };
  EXPECT_NEAR(base(0.3, 0.0), 0.0, 1e-9);
  EXPECT_NEAR(base(0.0, 0.3), 270.0, 1e-9);
  EXPECT_NEAR(base(-0.3, 0.0), 180.0, 1e-9);
  const Eigen::Vector3d right_down = Eigen::Vector3d(0.2, -0.2, -1.0).normalized();
  EXPECT_NEAR(as_worn(lens, right_down, 13.5e-3).base_deg.value(), 45.0, 1e-9);
  // First order by hand for the slope θ: F₁ = 4, F₂ = 5 − 4/(1 − 4·0.002/1.5) = 0.978552 D; behind the back n s = θ (1
  // − 0.0255 F₂) = 0.975047 θ, at the front y = (0.0255 + 0.002/1.5 · 0.975047) θ = 0.0268001 θ, outside 0.975047 θ − 4
  // y = 0.867847 θ: bent by 0.132153 θ.
  const double angle = 0.02, prism = as_worn(lens, gaze_direction(angle, 0.0), 13.5e-3).prism_cm_per_m();
  EXPECT_NEAR(prism, 13.2153 * angle, 2.0 * angle * angle * prism);  // the next order is θ² of it
}

TEST(AsWorn, LostChiefRaysHaveAStatus) {
  Spectacles lens = single_vision({-3.0, 0.0, 180.0}, {});
  lens.diameter_m = 20e-3;
  EXPECT_EQ(as_worn(lens, gaze_direction(0.6, 0.0), 13.5e-3).status, LensStatus::missed_lens);
}

TEST(AsWorn, NoPowerWhereAFocalLineLiesOnTheVertexSphere) {
  // Plane back in the front's focus: the light of a distant object meets in the back vertex, on the sphere.
  Spectacles lens;
  lens.front = SphereSurface{1000.0};
  lens.center_thickness_m = 3e-3;
  const AsWorn worn = as_worn(lens, ahead, 13.5e-3);
  EXPECT_EQ(worn.status, LensStatus::ok);
  EXPECT_FALSE(worn.power);
}

}  // namespace
}  // namespace sturm
