#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "compare/studies/bench/curve.h"

namespace sturm {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

constexpr double rounding = 1e-12;  // a few operations in double

std::vector<CostPoint> points_of(std::initializer_list<std::pair<double, double>> seconds_and_errors) {
  std::vector<CostPoint> points;
  for (const auto& [seconds, error] : seconds_and_errors)
    points.push_back({100.0 * seconds, seconds, error, std::nullopt});
  return points;
}

TEST(BenchCurve, APowerLawGivesItsOwnSlope) {
  std::vector<CostPoint> points;
  for (const double n : {4.0, 16.0, 64.0, 256.0}) points.push_back({n, 1.0, 3.0 * std::pow(n, -0.73), std::nullopt});
  const auto law = fit_power_law(points);
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->slope, -0.73, rounding);
  EXPECT_NEAR(law->standard_error.value(), 0.0, rounding);
}

TEST(BenchCurve, SlopeAndScatterByHand) {
  // log₂ x = 0, 1, 2 and log₂ y = 0, −1, −1: least squares gives slope −1/2, residuals (−1/6, 1/3, −1/6), Σ = 1/6, Σ(x
  // − x̄)² = 2, standard error √(1/6/1/2) = 0.288675.
  const std::vector<CostPoint> points = {{1.0, 1.0, 1.0, {}}, {2.0, 1.0, 0.5, {}}, {4.0, 1.0, 0.5, {}}};
  const auto law = fit_power_law(points);
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->slope, -0.5, rounding);
  EXPECT_NEAR(law->standard_error.value(), 0.28867513459481287, rounding);
}

TEST(BenchCurve, StandardErrorsPropagateToTheSlope) {
  // Two points a factor e² apart: x − x̄ = ∓1, Σ = 2; relative errors 3 % and 4 % give √(9 + 16) %/2 = 2.5 %.
  const std::vector<CostPoint> points = {{1.0, 1.0, 1.0, 0.03}, {std::exp(2.0), 1.0, 0.5, 0.02}};
  EXPECT_NEAR(fit_power_law(points)->standard_error.value(), 0.025, rounding);
  // On an exact line there is no scatter, and the propagated part stands.
  const std::vector<CostPoint> line = {
      {1.0, 1.0, 1.0, 0.03}, {std::exp(1.0), 1.0, std::exp(-0.5), 0.0}, {std::exp(2.0), 1.0, std::exp(-1.0), 0.0}};
  EXPECT_NEAR(fit_power_law(line)->standard_error.value(), 0.015, rounding);
}

TEST(BenchCurve, NoSlopeWithoutTwoDifferentSamples) {
  EXPECT_FALSE(fit_power_law({}));
  const std::vector<CostPoint> one = {{4.0, 1.0, 0.1, 0.01}}, same = {{4.0, 1.0, 0.1, 0.01}, {4.0, 2.0, 0.2, 0.01}};
  EXPECT_FALSE(fit_power_law(one));
  EXPECT_FALSE(fit_power_law(same));
  const std::vector<CostPoint> two = {{4.0, 1.0, 0.1, {}}, {8.0, 2.0, 0.2, {}}};
  const auto of_two = fit_power_law(two);  // a factor of two is enough
  ASSERT_TRUE(of_two);
  EXPECT_FALSE(of_two->standard_error);
  // Nearly the same samples would give a slope of about 60 here.
  const std::vector<CostPoint> nearly = {{1.0, 1.0, 0.2, 0.01}, {1.02, 1.0, 0.1, 0.01}, {1.01, 1.0, 0.4, 0.01}};
  EXPECT_FALSE(fit_power_law(nearly));
}

TEST(BenchCurve, TheFrontHoldsWhatNothingBeats) {
  const auto points = points_of({{4.0, 1.0}, {1.0, 3.0}, {2.0, 3.5}, {3.0, 1.0}, {2.5, 2.0}, {2.5, 2.0}});
  // (4, 1) is beaten by (3, 1), (2, 3.5) by (1, 3); equal points do not beat each other.
  EXPECT_THAT(pareto_front(points), ElementsAre(1, 4, 5, 3));
  EXPECT_TRUE(pareto_front({}).empty());
}

TEST(BenchCurve, TimesAreInterpolatedOnLogLogAxes) {
  const auto points = points_of({{1.0, 1.0}, {4.0, 0.25}, {16.0, 0.125}});
  const TimeToReach between = time_to_reach(points, 0.5);  // slope −1 there
  EXPECT_EQ(between.reach, Reach::Interpolated);
  EXPECT_NEAR(between.seconds.value(), 2.0, 10 * rounding);
  EXPECT_NEAR(time_to_reach(points, 0.125 * std::sqrt(2.0)).seconds.value(), 8.0, 100 * rounding);  // slope −1/2
  EXPECT_NEAR(time_to_reach(points, 0.25).seconds.value(), 4.0, 10 * rounding);
  const TimeToReach first = time_to_reach(points, 2.0);
  EXPECT_EQ(first.reach, Reach::AtOnce);
  EXPECT_NEAR(first.seconds.value(), 1.0, rounding);
  const TimeToReach never = time_to_reach(points, 0.1);
  EXPECT_EQ(never.reach, Reach::Never);
  EXPECT_FALSE(never.seconds);
}

TEST(BenchCurve, TheFirstTimeCountsWhereACurveIsNotMonotonous) {
  const auto points = points_of({{8.0, 0.2}, {1.0, 1.0}, {2.0, 0.25}, {4.0, 0.5}});  // in any order
  EXPECT_NEAR(time_to_reach(points, 0.5).seconds.value(), std::sqrt(2.0), 10 * rounding);
}

TEST(BenchCurve, TwoPowerLawsCrossOnce) {
  // 1/t against 1/√t · 1/2: equal at t = 4, error 1/4; the steeper one is ahead afterwards.
  std::vector<CostPoint> steep, flat;
  for (const double t : {1.0, 3.0, 9.0, 27.0}) steep.push_back({t, t, 1.0 / t, {}});
  for (const double t : {2.0, 20.0}) flat.push_back({t, t, 0.5 / std::sqrt(t), {}});
  const auto crossings = crossovers(steep, flat);
  ASSERT_EQ(crossings.size(), 1u);
  EXPECT_NEAR(crossings[0].seconds, 4.0, 100 * rounding);
  EXPECT_NEAR(crossings[0].error, 0.25, 10 * rounding);
  EXPECT_TRUE(crossings[0].a_ahead_after);
  EXPECT_FALSE(crossovers(flat, steep).at(0).a_ahead_after);
}

TEST(BenchCurve, NoCrossingOutsideOfWhatBothCover) {
  const auto early = points_of({{1.0, 1.0}, {2.0, 0.5}}), late = points_of({{4.0, 0.9}, {8.0, 0.1}}),
             above = points_of({{1.0, 2.0}, {2.0, 1.0}});
  EXPECT_TRUE(crossovers(early, late).empty());
  EXPECT_TRUE(crossovers(early, above).empty());
  EXPECT_TRUE(crossovers(early, {}).empty());
}

TEST(BenchCurve, TouchingIsNoCrossing) {
  const auto line = points_of({{1.0, 1.0}, {16.0, 1.0}});
  EXPECT_TRUE(crossovers(line, points_of({{1.0, 2.0}, {4.0, 1.0}, {16.0, 2.0}})).empty());
  EXPECT_TRUE(crossovers(line, line).empty());
  // Running together from 2 to 4 s and then on to the other side: the crossing is where they met.
  const auto crossing = crossovers(line, points_of({{1.0, 2.0}, {2.0, 1.0}, {4.0, 1.0}, {16.0, 0.5}}));
  ASSERT_EQ(crossing.size(), 1u);
  EXPECT_THAT(crossing[0].seconds, DoubleNear(2.0, 10 * rounding));
  EXPECT_FALSE(crossing[0].a_ahead_after);
}

}  // namespace
}  // namespace sturm
