#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/ellipses/bundle_points.h"
#include "compare/ellipses/ellipse_comparison.h"
#include "lensmodel/units.h"
#include "support/source_folder.h"

namespace sturm {
namespace {

using testing::mapped, testing::random_disc;

Eigen::Matrix2d rotation(double degrees) {
  const double a = degrees * radians_per_degree;
  Eigen::Matrix2d r;
  r << std::cos(a), -std::sin(a), std::sin(a), std::cos(a);
  return r;
}

Eigen::Matrix2d covariance_of(double major, double minor, double degrees) {
  return rotation(degrees) * Eigen::Vector2d(0.25 * major * major, 0.25 * minor * minor).asDiagonal() *
         rotation(degrees).transpose();
}

/// A "measurement" with chosen covariance and independent standard errors of its entries.
BundleEllipse measured_as(const Eigen::Matrix2d& covariance, const Eigen::Vector3d& standard_errors) {
  BundleEllipse e;
  e.covariance = covariance;
  e.ellipse = Ellipse::of_second_moments(covariance);
  e.entry_covariance = standard_errors.cwiseAbs2().asDiagonal();
  return e;
}

TEST(EllipseComparison, ZScoresAreSignedAndAlongThePredictedAxes) {
  const Eigen::Matrix2d predicted =
      covariance_of(4.0, 2.0, 90.0);  // major axis upright: var major = yy = 4, var minor = xx = 1
  Eigen::Matrix2d measured;
  measured << 0.7, 0.05, 0.05, 4.2;
  const EllipseComparison c = compare_to_prediction(measured_as(measured, {0.1, 0.02, 0.4}), predicted);
  EXPECT_NEAR((*c.z)[0], 0.2 / 0.4, 1e-12);
  EXPECT_NEAR((*c.z)[1], -0.3 / 0.1, 1e-12);
  EXPECT_NEAR(std::abs((*c.z)[2]), 0.05 / 0.02, 1e-12);  // its sign depends on which way the axes point
  EXPECT_NEAR(*c.z_max, 3.0, 1e-12);
}

TEST(EllipseComparison, StandardErrorsTurnWithTheAxes) {
  const Eigen::Matrix2d predicted = covariance_of(4.0, 2.0, 45.0);
  const Eigen::Vector2d u(std::sqrt(0.5), std::sqrt(0.5));
  const EllipseComparison c =
      compare_to_prediction(measured_as(predicted + 0.3 * u * u.transpose(), {0.2, 0.1, 0.2}), predicted);
  // var(uᵀΣu) = (0.2² + (2·0.1)² + 0.2²)/4
  EXPECT_NEAR((*c.z)[0], 0.3 / std::sqrt(0.03), 1e-12);
  EXPECT_NEAR((*c.z)[1], 0.0, 1e-12);
  EXPECT_NEAR((*c.z)[2], 0.0, 1e-12);
}

TEST(EllipseComparison, ErrorsOfAxesAndAngleAreSigned) {
  const EllipseComparison c =
      compare_to_prediction(measured_as(covariance_of(4.4, 1.8, 25.0), {1, 1, 1}), covariance_of(4.0, 2.0, 30.0));
  EXPECT_NEAR(*c.semi_major_relative_error, 0.1, 1e-12);
  EXPECT_NEAR(*c.semi_minor_relative_error, -0.1, 1e-12);
  EXPECT_NEAR(c.semi_minor_error, -0.2, 1e-12);
  EXPECT_NEAR(*c.orientation_error_deg, -5.0, 1e-10);
}

TEST(EllipseComparison, OrientationErrorIsFolded) {
  const auto error = [](double measured, double predicted) {
    return *compare_to_prediction(measured_as(covariance_of(3, 1, measured), {1, 1, 1}), covariance_of(3, 1, predicted))
                .orientation_error_deg;
  };
  EXPECT_NEAR(error(-88.0, 89.0), 3.0, 1e-9);
  EXPECT_NEAR(error(89.0, -88.0), -3.0, 1e-9);
  EXPECT_NEAR(error(60.0, -60.0), -60.0, 1e-9);
}

TEST(EllipseComparison, CirclesHaveNoOrientationError) {
  const Eigen::Matrix2d slim = covariance_of(3, 1, 10), round = covariance_of(1.0, 0.995, 10);
  EXPECT_FALSE(compare_to_prediction(measured_as(slim, {1, 1, 1}), round).orientation_error_deg);
  EXPECT_FALSE(compare_to_prediction(measured_as(round, {1, 1, 1}), slim).orientation_error_deg);
  EXPECT_TRUE(compare_to_prediction(measured_as(covariance_of(1.0, 0.98, 10), {1, 1, 1}), slim).orientation_error_deg);
}

TEST(EllipseComparison, FocalLineHasALengthAndNoRelativeErrorAcross) {
  const EllipseComparison c =
      compare_to_prediction(measured_as(covariance_of(2.0, 0.03, 0.0), {1, 1, 1}), covariance_of(2.0, 0.0, 0.0));
  EXPECT_FALSE(c.semi_minor_relative_error);
  EXPECT_NEAR(c.semi_minor_error, 0.03, 1e-12);
  EXPECT_NEAR(*c.semi_major_relative_error, 0.0, 1e-12);
}

TEST(EllipseComparison, PredictedPointHasNoRelativeErrors) {
  const BundleEllipse nothing = measured_as(Eigen::Matrix2d::Zero(), {0, 0, 0});
  const EllipseComparison same = compare_to_prediction(nothing, Eigen::Matrix2d::Zero());
  EXPECT_FALSE(same.relative_frobenius);
  EXPECT_FALSE(same.semi_major_relative_error);
  EXPECT_EQ(*same.z_max, 0.0);
  EXPECT_EQ(same.bures_wasserstein, 0.0);
  const EllipseComparison wide =
      compare_to_prediction(measured_as(covariance_of(1, 1, 0), {0, 0, 0}), Eigen::Matrix2d::Zero());
  EXPECT_GT(*wide.z_max, 1e100);  // certainly different, and finite
  EXPECT_TRUE(std::isfinite(*wide.z_max));
}

TEST(EllipseComparison, RoundingOfAFocalLineIsNotADifference) {
  // rays of a slanted focal line: the measured width is rounding, and so is its standard error
  const Eigen::Vector2d u(std::cos(0.3), std::sin(0.3));
  const Eigen::Matrix2d line = u * u.transpose();
  std::vector<BundleMoments> replicates(16);
  for (std::size_t r = 0; r < replicates.size(); ++r) replicates[r].add(mapped(line, random_disc(1000, r)));
  const EllipseComparison c = compare_to_prediction(summarise(replicates, PointSet::Independent), 0.25 * line);
  EXPECT_LT(std::abs((*c.z)[1]), 1.0);
  EXPECT_LT(std::abs((*c.z)[2]), 1.0);
  EXPECT_LT(*c.z_max, 6.0);  // t₁₅ beyond 6 has p = 2e-5
}

TEST(EllipseComparison, NoStandardErrorMeansNoZ) {
  BundleEllipse e = measured_as(covariance_of(1, 1, 0), {1, 1, 1});
  e.entry_covariance.reset();
  EXPECT_FALSE(compare_to_prediction(e, covariance_of(1, 1, 0)).z);
  EXPECT_FALSE(compare_to_prediction(e, covariance_of(1, 1, 0)).z_max);
}

TEST(BuresWasserstein, OfCommutingMatricesIsTheDistanceOfTheStandardDeviations) {
  // same axes, standard deviations (3, 1) and (1, 2): √(2² + 1²)
  for (const double angle : {0.0, 30.0, 150.0})
    EXPECT_NEAR(bures_wasserstein_distance(covariance_of(6, 2, angle), covariance_of(2, 4, angle)), std::sqrt(5.0),
                1e-13);
}

TEST(BuresWasserstein, OfCrossedLinesHasNoSharedMass) {
  EXPECT_NEAR(bures_wasserstein_distance(covariance_of(2, 0, 20), covariance_of(2, 0, 110)), std::sqrt(2.0),
              1e-13);  // tr A + tr B
  EXPECT_NEAR(bures_wasserstein_distance(covariance_of(2, 0, 20), Eigen::Matrix2d::Zero()), 1.0, 1e-13);
}

RC_GTEST_PROP(BuresWasserstein, IsTheTraceFormula, ()) {
  const auto number = [] { return *rc::gen::inRange(1, 1000) * 1e-3; };
  const Eigen::Matrix2d a = covariance_of(number(), number(), 180.0 * number()),
                        b = covariance_of(number(), number(), 180.0 * number());
  const double squared =
      a.trace() + b.trace() - 2.0 * std::sqrt((a * b).trace() + 2.0 * std::sqrt(a.determinant() * b.determinant()));
  const double d = bures_wasserstein_distance(a, b);
  RC_ASSERT(std::abs(d * d - squared) < 1e-14);  // the trace formula's own cancellation, entries ≤ 0.5
  RC_ASSERT(std::abs(d - bures_wasserstein_distance(b, a)) < 1e-14);
}

TEST(BuresWasserstein, StaysAccurateForNearlyEqualMatrices) {
  const double h = 1e-11;  // the trace formula would see nothing below √ε = 1.5e-8
  const double d = bures_wasserstein_distance(covariance_of(2.0 * (1.0 + h), 1.0, 37.0), covariance_of(2.0, 1.0, 37.0));
  EXPECT_NEAR(d / h, 1.0, 1e-4);  // standard deviation 1 changed by h; ε/h
  EXPECT_LT(bures_wasserstein_distance(covariance_of(2, 1, 37), covariance_of(2, 1, 37)), 1e-15);
}

TEST(Sin2ClosedForm, PrincipalVariancesOfPhysics41) {
  const double a = 0.002, v1 = 3.0, v2 = -1.25;
  const Eigen::Matrix2d v = rotation(33.0) * Eigen::Vector2d(v1, v2).asDiagonal() * rotation(33.0).transpose();
  const Eigen::Matrix2d c = rotation(33.0).transpose() * sin2_closed_form_covariance(v, a) * rotation(33.0);
  EXPECT_NEAR(c(0, 0), a * a / 4 * (5 * v1 * v1 + 2 * v1 * v2 + v2 * v2) / 8, 1e-19);
  EXPECT_NEAR(c(1, 1), a * a / 4 * (v1 * v1 + 2 * v1 * v2 + 5 * v2 * v2) / 8, 1e-19);
  EXPECT_NEAR(c(0, 1), 0.0, 1e-19);
}

TEST(Sin2ClosedForm, IsTheQuadratureOfTheRayModel) {
  // s = (v₁ cos²(φ − θ) + v₂ sin²(φ − θ))·p over the disc, by a rule that is exact for it: E[r²] = a²/2 and equal
  // angles
  const double a = 0.003, v1 = -0.4, v2 = 2.6, theta = 150.0 * radians_per_degree;
  Eigen::Matrix2d v = rotation(150.0) * Eigen::Vector2d(v1, v2).asDiagonal() * rotation(150.0).transpose();
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  constexpr int angles = 64;
  for (int k = 0; k < angles; ++k) {
    const double phi = 2.0 * std::numbers::pi * k / angles;
    const double power = v1 * std::pow(std::cos(phi - theta), 2) + v2 * std::pow(std::sin(phi - theta), 2);
    const Eigen::Vector2d s = power * Eigen::Vector2d(std::cos(phi), std::sin(phi));
    sum += 0.5 * a * a / angles * s * s.transpose();
  }
  EXPECT_NEAR((sin2_closed_form_covariance(v, a) - sum).norm() / sum.norm(), 0.0, 1e-14);
}

TEST(Sin2ClosedForm, MatchesTheIndependentReference) {
  std::ifstream file(STURM_SOURCE_DIR "/tests/reference/naked_eye_blur.json");
  const nlohmann::json reference = nlohmann::json::parse(file);
  int cases = 0;
  for (const nlohmann::json& c : reference["cases"]) {
    const auto& m = c["outputs"]["M_xx_xy_yy_D"];
    const auto& expected = c["outputs"]["sin2_radial"]["cov_rad2_xx_xy_yy"];
    Eigen::Matrix2d v, e;
    v << m[0].get<double>(), m[1].get<double>(), m[1].get<double>(), m[2].get<double>();
    e << expected[0].get<double>(), expected[1].get<double>(), expected[1].get<double>(), expected[2].get<double>();
    const Eigen::Matrix2d mine = sin2_closed_form_covariance(v, 0.5e-3 * c["inputs"]["pupil_mm"].get<double>());
    EXPECT_LE((mine - e).norm(), 1e-12 * e.norm()) << c["id"];  // what its README says a double can meet
    ++cases;
  }
  EXPECT_EQ(cases, 150);
}

TEST(Sin2ClosedForm, HalvesTheDifferenceAndLosesAKnownVariance) {
  const double a = 0.0025, c = 1.75;
  const Eigen::Matrix2d v = Eigen::Vector2d(0.6, 0.6 + c).asDiagonal();
  const Eigen::Matrix2d sin2 = sin2_closed_form_covariance(v, a), wave = covariance_of_disc_image(v, a);
  EXPECT_NEAR((sin2(1, 1) - sin2(0, 0)) / (wave(1, 1) - wave(0, 0)), 0.5, 1e-14);
  EXPECT_NEAR((wave - sin2).trace(), a * a * c * c / 16.0, 1e-18);
}

}  // namespace
}  // namespace sturm
