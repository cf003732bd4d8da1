// Every case of tests/reference/thick_lens.json: exact rays and wavefronts through thick spherical and toric lenses by
// other people's programs (Optiland, ray-optics, 40-digit arithmetic). Real rays go through lensmodel alone, first
// order through conoid alone.
#include <gtest/gtest.h>

#include <cmath>

#include "conoid/tracing/spectacle_conoid.h"
#include "lensmodel/gaze.h"
#include "support/quadrature.h"
#include "support/thick_lens_cases.h"

namespace sturm {
namespace {

using nlohmann::json;
using testing::ThickLensCase;

constexpr double nanometre_per_thousand = 1e-12;  // 1e-9 mm; the file's programs agree to 8e-14 mm

const std::vector<ThickLensCase>& cases() {
  static const std::vector<ThickLensCase> all = testing::thick_lens_cases();
  return all;
}

/// The ray through the pupil point p of the turned eye [m], launched with the slope S p.
LensPath ray_through(const ThickLensCase& c, const Eigen::Vector2d& p, double accommodation_D) {
  const Eigen::Matrix3d turn = smallest_rotation({0.0, 0.0, -1.0}, c.gaze);
  const Eigen::Vector2d slope = c.eye.slope_matrix(accommodation_D).slope(p);
  const Eigen::Vector3d origin =
      turned_pupil_center(c.gaze, c.eye.rotation_center_m) + turn * Eigen::Vector3d(p.x(), p.y(), 0.0);
  return trace(c.lens, {origin, (turn * Eigen::Vector3d(slope.x(), slope.y(), -1.0)).normalized()});
}

/// Calls check(key of the spot, distance [m], accommodation [D], spot) for the six spots of a case.
void for_each_spot(const ThickLensCase& c, const auto& check) {
  for (const auto& [key, spot] : c.json["outputs"]["spots_4mm"].items()) {
    const double distance = std::stod(key);
    check(c.id + " " + key, distance, key.ends_with("accommodated") ? 1.0 / distance : 0.0, spot);
  }
}

TEST(ThickLensReference, HasAllItsCases) {
  ASSERT_EQ(cases().size(), 117u);
}

TEST(ThickLensReference, ChiefRays) {
  for (const ThickLensCase& c : cases()) {
    const SpectacleConoid conoid = trace_conoid(c.lens, c.gaze, c.eye.rotation_center_m);
    ASSERT_EQ(conoid.status, LensStatus::ok) << c.id;
    const json& chief = c.json["outputs"]["chief"];
    EXPECT_LT((conoid.chief_ray.origin - ThickLensCase::point(chief["exit_point_mm"])).norm(), nanometre_per_thousand)
        << c.id;
    EXPECT_LT((conoid.chief_ray.direction - ThickLensCase::direction(chief["exit_dir"])).norm(), 1e-12) << c.id;
    EXPECT_LT((ray_through(c, {0.0, 0.0}, 0.0).back_point - ThickLensCase::point(chief["back_point_mm"])).norm(),
              nanometre_per_thousand)
        << c.id;
    // Frames: the examiner's e1 points the other way.
    EXPECT_LT((conoid.exit.e1 + ThickLensCase::direction(c.json["outputs"]["e1"])).norm(), 1e-12) << c.id;
    EXPECT_LT((conoid.exit.e2 - ThickLensCase::direction(c.json["outputs"]["e2"])).norm(), 1e-12) << c.id;
  }
}

TEST(ThickLensReference, ExitWavefronts) {
  for (const ThickLensCase& c : cases()) {
    const SpectacleConoid conoid = trace_conoid(c.lens, c.gaze, c.eye.rotation_center_m);
    const auto k = conoid.exit_curvature(c.eye.correction.matrix());
    ASSERT_TRUE(k) << c.id;
    // The file's Q is positive for diverging waves. Peers agree to 2e-11 D.
    const Eigen::Matrix2d expected =
        -ThickLensCase::symmetric(c.json["outputs"]["exit_wavefront_curvature_D_11_12_22"]["coddington"]);
    EXPECT_LT((*k - expected).cwiseAbs().maxCoeff(), 1e-8) << c.id << "\n" << *k << "\n" << expected;
  }
}

TEST(ThickLensReference, FirstOrderFootprints) {
  for (const ThickLensCase& c : cases()) {
    const SpectacleConoid conoid = trace_conoid(c.lens, c.gaze, c.eye.rotation_center_m);
    for_each_spot(c, [&](const std::string& what, double distance, double accommodation, const json& spot) {
      const Footprint f = spectacle_footprint(conoid, c.eye, distance, accommodation);
      const Eigen::Matrix2d expected = ThickLensCase::symmetric(spot["linear_cov_mm2_xx_xy_yy"], 1e-6);
      EXPECT_LT((covariance_of_disc_image(f.transverse(), c.eye.pupil_radius_m) - expected).norm(),
                1e-8 * expected.norm())
          << what;
    });
  }
}

TEST(ThickLensReference, RealRaysBySpots) {
  for (const ThickLensCase& c : cases()) {
    const SpectacleConoid conoid = trace_conoid(c.lens, c.gaze, c.eye.rotation_center_m);
    const Eigen::Vector3d exit = conoid.chief_ray.origin, forward = conoid.chief_ray.direction;
    for_each_spot(c, [&](const std::string& what, double distance, double accommodation, const json& spot) {
      int lost = 0;
      // 14 × 56 nodes, as in the file: the integrand is smooth, so both quadratures are exact to rounding (the file
      // says 1.4e-12).
      const Eigen::Matrix2d covariance =
          testing::covariance_over_disc(c.eye.pupil_radius_m, 14, 56, [&](const Eigen::Vector2d& p) {
            const LensPath path = ray_through(c, p, accommodation);
            lost += path.status != LensStatus::ok;
            const double t = (distance - (path.exit.origin - exit).dot(forward)) / path.exit.direction.dot(forward);
            const Eigen::Vector3d there = path.exit.at(t) - exit;
            return Eigen::Vector2d(there.dot(conoid.exit.e1), there.dot(conoid.exit.e2));
          });
      EXPECT_EQ(lost, 0) << what;
      const Eigen::Matrix2d expected = ThickLensCase::symmetric(spot["cov_mm2_xx_xy_yy"], 1e-6);
      EXPECT_LT((covariance - expected).norm(), 1e-8 * expected.norm()) << what;
    });
  }
}

TEST(ThickLensReference, SampleRays) {
  std::size_t count = 0;
  for (const ThickLensCase& c : cases()) {
    for (const json& ray : c.json["outputs"]["sample_rays"]) {
      const LensPath path = ray_through(c, ThickLensCase::pupil_point(ray["pupil_xy_mm"]), 0.0);
      ASSERT_EQ(path.status, LensStatus::ok) << c.id;
      EXPECT_LT((path.exit.origin - ThickLensCase::point(ray["exit_point_mm"])).norm(), nanometre_per_thousand) << c.id;
      EXPECT_LT((path.exit.direction - ThickLensCase::direction(ray["exit_dir"])).norm(), 1e-12) << c.id;
      ++count;
    }
  }
  EXPECT_EQ(count, 4u * 117u);
}

}  // namespace
}  // namespace sturm
