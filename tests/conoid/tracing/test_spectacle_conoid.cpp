#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "conoid/tracing/spectacle_conoid.h"
#include "lensmodel/gaze.h"
#include "lensmodel/single_vision.h"
#include "lensmodel/symmetric2.h"
#include "support/drawn.h"
#include "support/fixed_rapidcheck_seed.h"
#include "support/units.h"

namespace sturm {
namespace {

using testing::degree;
using testing::drawn;
using testing::mm;

constexpr double eye_center = 13.5 * mm;

Prescription any_prescription() {
  return {drawn(-32, 24, 0.25), drawn(-16, 16, 0.25), drawn(0, 180, 1.0), 12e-3};
}

Spectacles any_lens(const Prescription& rx) {
  return single_vision(
      rx, {drawn(0, 32, 0.25), drawn(10, 60, 0.1 * mm), 1.5 + drawn(0, 24, 0.01), drawn(80, 180, 0.1 * mm), 90 * mm});
}

Eigen::Vector3d any_gaze() {
  return gaze_direction(drawn(-300, 300, 0.1 * degree), drawn(-300, 300, 0.1 * degree));
}

Eigen::Matrix2d transverse(const SpectacleConoid& c, const Eigen::Matrix2d& slopes, double distance) {
  return distance * c.angular_footprint(slopes, 1.0 / distance);
}

/// Rays of first order conserve phase space: the 4 × 4 matrix from air to air is symplectic, so a bundle with symmetric
/// S stays a wave.
RC_GTEST_PROP(SpectacleConoid, IsSymplectic, ()) {
  const Prescription rx = any_prescription();
  const SpectacleConoid c = trace_conoid(any_lens(rx), any_gaze(), eye_center);
  RC_PRE(c.status == LensStatus::ok);
  const RayTransfer& m = c.exit;
  const Eigen::Matrix2d a = m.offset_from_offset, b = m.offset_from_slope, g = m.slope_from_offset,
                        d = m.slope_from_slope;
  RC_ASSERT((a.transpose() * g - g.transpose() * a).norm() <= 1e-12);
  RC_ASSERT((b.transpose() * d - d.transpose() * b).norm() <= 1e-12);
  RC_ASSERT((a.transpose() * d - g.transpose() * b - Eigen::Matrix2d::Identity()).norm() <= 1e-12);
  const Eigen::Matrix2d s = power_at_cornea(rx).matrix(), ab = m.offsets(s).transpose() * m.slopes(s);
  RC_ASSERT((ab - ab.transpose()).norm() <= 1e-12 * std::max(1.0, s.norm()));
}

RC_GTEST_PROP(SpectacleConoid, ALensOfThePrescriptionSendsAPlaneWaveOutOnTheAxis, ()) {
  const Prescription rx = any_prescription();
  const Spectacles lens = any_lens(rx);
  const SpectacleConoid c = trace_conoid(lens, {0.0, 0.0, -1.0}, eye_center);
  RC_ASSERT(c.status == LensStatus::ok);
  const PowerMatrix needed = PowerMatrix::from(rx).moved_towards_eye(lens.vertex_distance_m);
  // Independent of the maker's formula: the conoid's refractions and transfers undo the eye's error. Powers of up to 20
  // D carry 1e-14 D.
  RC_ASSERT(c.exit_curvature(needed.matrix())->norm() <= 1e-12 * std::max(1.0, needed.matrix().norm()) + 1e-12);
}

RC_GTEST_PROP(SpectacleConoid, TurnsWithTheWholeSystem, ()) {
  const double alpha_deg = drawn(-90, 90, 1.0), alpha = alpha_deg * degree;
  const Prescription rx = any_prescription();
  const double front = drawn(0, 16, 1.0), sweep = drawn(2, 16, 1.0), generator = drawn(2, 16, 1.0),
               meridian = drawn(0, 180, 1.0);
  Spectacles lens;
  lens.front = SphereSurface{front};
  lens.back = TorusSurface(sweep, generator, meridian);
  Spectacles turned_lens = lens;
  turned_lens.back =
      TorusSurface(sweep, generator, meridian - alpha_deg);  // TABO counts the other way round than the wearer sees it
  const Eigen::Vector3d gaze = any_gaze(), turned_gaze = Eigen::AngleAxisd(alpha, Eigen::Vector3d::UnitZ()) * gaze;
  const SpectacleConoid c = trace_conoid(lens, gaze, eye_center),
                        t = trace_conoid(turned_lens, turned_gaze, eye_center);
  RC_PRE(c.status == LensStatus::ok && t.status == LensStatus::ok);
  const Eigen::Matrix2d r = Eigen::Rotation2Dd(alpha).toRotationMatrix(), f = power_at_cornea(rx).matrix();
  RC_ASSERT(
      (t.chief_ray.direction - Eigen::AngleAxisd(alpha, Eigen::Vector3d::UnitZ()) * c.chief_ray.direction).norm() <=
      1e-14);
  RC_ASSERT((transverse(t, r * f * r.transpose(), 0.7) - r * transverse(c, f, 0.7) * r.transpose()).norm() <=
            1e-12 * std::max(1.0, f.norm()));
}

RC_GTEST_PROP(SpectacleConoid, ScalesWithAllLengths, ()) {
  const double k = drawn(2, 40, 0.25), sweep = drawn(2, 16, 1.0), generator = drawn(2, 16, 1.0),
               front = drawn(0, 16, 1.0);
  Spectacles lens, big;
  lens.front = SphereSurface{front};
  lens.back = TorusSurface(sweep, generator, 25.0);
  big.front = SphereSurface{front / k};
  big.back = TorusSurface(sweep / k, generator / k, 25.0);
  big.center_thickness_m = k * lens.center_thickness_m;
  big.vertex_distance_m = k * lens.vertex_distance_m;
  big.diameter_m = k * lens.diameter_m;
  const Eigen::Vector3d gaze = any_gaze();
  const SpectacleConoid c = trace_conoid(lens, gaze, eye_center), b = trace_conoid(big, gaze, k * eye_center);
  RC_PRE(c.status == LensStatus::ok && b.status == LensStatus::ok);
  const Eigen::Matrix2d s = power_at_cornea(any_prescription()).matrix();
  RC_ASSERT((b.chief_ray.origin - k * c.chief_ray.origin).norm() <= 1e-14 * k);
  RC_ASSERT((transverse(b, s / k, 0.7 * k) - transverse(c, s, 0.7)).norm() <= 1e-12 * std::max(1.0, s.norm()));
}

RC_GTEST_PROP(SpectacleConoid, DoesNotDependOnHowThePrescriptionIsWritten, ()) {
  const Prescription rx = any_prescription();
  const Eigen::Vector3d gaze = any_gaze();
  const SpectacleConoid a = trace_conoid(single_vision(rx, {}), gaze, eye_center),
                        b = trace_conoid(single_vision(transposed(rx), {}), gaze, eye_center);
  RC_PRE(a.status == LensStatus::ok);
  RC_ASSERT(b.status == LensStatus::ok);
  const Eigen::Matrix2d fa = power_at_cornea(rx).matrix(), fb = power_at_cornea(transposed(rx)).matrix();
  RC_ASSERT((transverse(a, fa, 2.0) - transverse(b, fb, 2.0)).norm() <= 1e-12 * std::max(1.0, fa.norm()));
}

TEST(SpectacleConoid, AnIndexOf1IsTheNakedEyeSeenFromTheExitPoint) {
  Spectacles air = single_vision({-4.0, -2.0, 40.0}, {});
  air.refractive_index = 1.0;
  Eye eye = Eye::with({-1.0, -2.5, 25.0, 12e-3}, 4e-3, BestAccommodation{5.0});
  const Eigen::Vector3d gaze = gaze_direction(25 * degree, -20 * degree);
  const SpectacleConoid c = trace_conoid(air, gaze, eye_center);
  const double way = (c.chief_ray.origin - turned_pupil_center(gaze, eye_center)).norm(), distance = 0.4;
  const double accommodation = accommodation_through(c, eye, 1.0 / distance);
  const Footprint naked = naked_eye_footprint(eye, distance + way),
                  through_air = spectacle_footprint(c, eye, distance, accommodation);
  EXPECT_NEAR(accommodation, naked.accommodation_D, 1e-13);  // the clamped mean, here found by bisection
  EXPECT_LT((naked.transverse() - through_air.transverse()).norm(), 1e-14);
}

TEST(SpectacleConoid, APlaneSlabIsAShorterWay) {
  // Oblique slab: the way t/(n cos φ') across the plane of incidence, t cos²φ/(n cos³φ') within it. Looking to the
  // right: x is within.
  Spectacles slab;
  slab.center_thickness_m = 6 * mm;
  const SpectacleConoid c = trace_conoid(slab, gaze_direction(30 * degree, 0.0), 0.0);  // cos φ = √3/2, cos φ' = √8/3
  ASSERT_EQ(c.status, LensStatus::ok);
  const double to_back = 12 * mm / 0.86602540378443865, cos_out = 0.94280904158206336;
  EXPECT_LT((c.exit.offset_from_offset - Eigen::Matrix2d::Identity()).norm(), 1e-14);
  EXPECT_LT(c.exit.slope_from_offset.norm(), 1e-14);
  EXPECT_LT((c.exit.slope_from_slope - Eigen::Matrix2d::Identity()).norm(), 1e-14);
  EXPECT_NEAR(c.exit.offset_from_slope(0, 0), to_back + 6 * mm * 0.75 / (1.5 * cos_out * cos_out * cos_out), 1e-16);
  EXPECT_NEAR(c.exit.offset_from_slope(1, 1), to_back + 6 * mm / (1.5 * cos_out), 1e-16);
  EXPECT_NEAR(c.exit.offset_from_slope(0, 1), 0.0, 1e-17);
}

TEST(SpectacleConoid, SurfacesConcentricWithTheRotationCentreAreTheSameInEveryDirection) {
  Spectacles lens;
  lens.back = SphereSurface{1.0 / (25.5 * mm)};
  lens.front = SphereSurface{1.0 / (27.5 * mm)};
  const SpectacleConoid ahead = trace_conoid(lens, {0.0, 0.0, -1.0}, eye_center);
  for (const auto& [azimuth, elevation] : {std::pair{30.0, 0.0}, {0.0, -25.0}, {21.0, 13.0}}) {
    const Eigen::Vector3d gaze = gaze_direction(azimuth * degree, elevation * degree);
    const SpectacleConoid c = trace_conoid(lens, gaze, eye_center);
    ASSERT_EQ(c.status, LensStatus::ok);
    EXPECT_LT((c.chief_ray.direction - gaze).norm(), 1e-15);
    EXPECT_LT((c.exit.offset_from_offset - ahead.exit.offset_from_offset).norm(), 1e-13);
    EXPECT_LT((c.exit.slope_from_offset - ahead.exit.slope_from_offset).norm(), 1e-12);
    EXPECT_LT((c.exit.slope_from_slope - ahead.exit.slope_from_slope).norm(), 1e-13);
  }
}

TEST(SpectacleConoid, PowerThroughZeroIsSmooth) {
  // The curvature of the outgoing wave passes through 0 with the lens's power: no jump, sign as the power that is
  // missing.
  const auto outgoing = [](double sphere) {
    return (*trace_conoid(single_vision({sphere}, {}), {0.0, 0.0, -1.0}, eye_center)
                 .exit_curvature(Eigen::Matrix2d::Zero()))(0, 0);
  };
  EXPECT_NEAR(outgoing(0.0), 0.0, 1e-14);
  EXPECT_GT(outgoing(1e-6), 0.0);  // a plus lens before an emmetrope: converging towards the scene
  EXPECT_LT(outgoing(-1e-6), 0.0);
  EXPECT_NEAR(outgoing(1e-6) / 1e-6, -outgoing(-1e-6) / 1e-6, 1e-5);
}

TEST(SpectacleConoid, FocalLinesHaveNoWidthAndNothingIsSingularThere) {
  const Spectacles lens = single_vision({1.0, -2.0, 180.0}, {});
  const Eye eye = Eye::with({0.0, 0.0, 180.0, 0.0}, 4e-3);
  const SpectacleConoid c = trace_conoid(lens, {0.0, 0.0, -1.0}, eye_center);
  // +1 D along AXIS 180, i.e. along x: the horizontal meridian meets the axis where A + dB = 0.
  const double a = c.exit.offset_from_offset(0, 0), b = c.exit.slope_from_offset(0, 0), d = -a / b;
  ASSERT_GT(d, 0.9);
  const Ellipse e = Ellipse::image_of_disc(spectacle_footprint(c, eye, d, 0.0).transverse(), eye.pupil_radius_m);
  EXPECT_LT(e.semi_minor, 1e-15 * e.semi_major + 1e-18);
  EXPECT_NEAR(*e.orientation_deg, 90.0, 1e-9);  // what is left is vertical
}

TEST(SpectacleConoid, AFocalLineInTheExitPointHasNoCurvature) {
  const SpectacleConoid c = trace_conoid(single_vision({0.0}, {}), {0.0, 0.0, -1.0}, eye_center);
  const double s = -c.exit.offset_from_offset(0, 0) / c.exit.offset_from_slope(0, 0);
  Eigen::Matrix2d slopes;
  slopes << s, 0.0, 0.0, 0.0;
  EXPECT_FALSE(c.exit_curvature(slopes));
  EXPECT_TRUE(std::isfinite(c.angular_footprint(slopes, 1.0).norm()));
  slopes(0, 0) = 0.99 * s;
  EXPECT_TRUE(c.exit_curvature(slopes));
}

TEST(SpectacleConoid, StatusesOfTheChiefRay) {
  Spectacles lens = single_vision({-2.0}, {});
  lens.diameter_m = 25 * mm;
  EXPECT_EQ(trace_conoid(lens, gaze_direction(30 * degree, 0.0), eye_center).status, LensStatus::missed_lens);
  Spectacles steep;
  steep.front = SphereSurface{-50.0};
  EXPECT_EQ(trace_conoid(steep, gaze_direction(25 * degree, 0.0), eye_center).status,
            LensStatus::total_internal_reflection);
}

TEST(BestAccommodation, IsExactlyAnEndOfTheRangeWhereMoreWouldBeWorse) {
  const SpectacleConoid c = trace_conoid(single_vision({-1.0}, {}), {0.0, 0.0, -1.0}, eye_center);
  EXPECT_EQ(best_accommodation(c, PowerMatrix::scalar(-5.0), 0.0, 4.0),
            0.0);  // too weak a lens for this myope: relaxed
  EXPECT_EQ(best_accommodation(c, PowerMatrix::scalar(-1.0), 10.0, 4.0), 4.0);  // a target at 10 cm: all there is
}

RC_GTEST_PROP(BestAccommodation, HasTheLeastMajorAxis, ()) {
  const Prescription rx = any_prescription();
  const SpectacleConoid c = trace_conoid(any_lens(any_prescription()), any_gaze(), eye_center);
  RC_PRE(c.status == LensStatus::ok);
  const PowerMatrix f = power_at_cornea(rx);
  const double vergence = drawn(0, 60, 0.1), amplitude = drawn(0, 100, 0.1);
  const double best = best_accommodation(c, f, vergence, amplitude);
  RC_ASSERT(best >= 0.0 && best <= amplitude);
  const auto major = [&](double a) {
    return singular_values(c.angular_footprint((f - PowerMatrix::scalar(a)).matrix(), vergence)).large;
  };
  // No point of a fine grid, and no close neighbour, is better by more than rounding of numbers of about 20.
  for (int i = 0; i <= 200; ++i) RC_ASSERT(major(best) <= major(amplitude * i / 200.0) + 1e-13);
  for (double step : {1e-6, 1e-4}) {
    RC_ASSERT(major(best) <= major(std::min(best + step, amplitude)) + 1e-13);
    RC_ASSERT(major(best) <= major(std::max(best - step, 0.0)) + 1e-13);
  }
}

}  // namespace
}  // namespace sturm
