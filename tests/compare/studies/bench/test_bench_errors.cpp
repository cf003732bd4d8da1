#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "compare/metrics/relative_mse.h"
#include "compare/metrics/rmse.h"
#include "compare/studies/bench/evaluation.h"
#include "compare/studies/bench/reference_image.h"
#include "compare/studies/bench/requirements.h"
#include "compare/studies/bench/two_bench_methods.h"
#include "io/files/error.h"

namespace sturm {
namespace {

using test::sample;
using test::two_methods;

constexpr int side = 12;
constexpr double error_rounding = 1e-12;

Image constant(float value) {
  Image image(side, side, 3);
  for (float& x : image.pixels) x = value;
  return image;
}

Image noisy(const Image& mean, double sigma, std::mt19937_64& random) {
  std::normal_distribution<double> normal(0.0, sigma);
  Image image = mean;
  for (float& x : image.pixels) x = static_cast<float>(x + normal(random));
  return image;
}

TEST(ReferenceImage, ErrorsByHand) {
  const ReferenceImage reference(constant(0.5f), constant(0.5f), std::nullopt, 1.0);
  const PictureErrors errors = reference.errors_of(constant(0.75f));
  EXPECT_NEAR(errors.mse, 0.0625, error_rounding);
  EXPECT_NEAR(errors.relative_mse, 0.0625 / 0.26, error_rounding);
  EXPECT_NEAR(errors.relative_mse_trimmed, 0.0625 / 0.26, error_rounding);
  EXPECT_EQ(reference.noise_floor().mse, 0.0);
  EXPECT_NEAR(reference.errors_of(constant(0.5f)).one_minus_ssim, 0.0, error_rounding);
}

TEST(ReferenceImage, EqualsTheMetricsOfCompare) {
  std::mt19937_64 random(3);
  const Image reference = noisy(constant(0.4f), 0.1, random), test = noisy(constant(0.5f), 0.2, random);
  const PictureErrors errors = ReferenceImage(reference, reference, std::nullopt, 1.0).errors_of(test);
  const RelativeMse relative = relative_mse(test, reference);
  EXPECT_NEAR(std::sqrt(errors.mse), rmse(test, reference), error_rounding);
  EXPECT_NEAR(errors.relative_mse, relative.plain, error_rounding);
  EXPECT_NEAR(errors.relative_mse_trimmed, relative.trimmed, error_rounding);
}

TEST(ReferenceImage, BrightNeighbourhoodsAreLeftOut) {
  // One pixel of radiance 90 in a picture of 0: the mean over 9 pixels is 10, over the 6 of an edge 15, over the 4 of a
  // corner 22.5.
  Image bright = constant(0.0f);
  for (int c = 0; c < 3; ++c) bright.at(5, 5)[c] = 90.0f;
  EXPECT_EQ(ReferenceImage(bright, bright, 9.99, 1.0).pixels_left_out(), 9u);
  EXPECT_EQ(ReferenceImage(bright, bright, 10.01, 1.0).pixels_left_out(), 0u);
  Image corner = constant(0.0f);
  for (int c = 0; c < 3; ++c) corner.at(0, 0)[c] = 90.0f;
  EXPECT_EQ(ReferenceImage(corner, corner, 9.99, 1.0).pixels_left_out(), 4u);
  EXPECT_EQ(ReferenceImage(corner, corner, 10.01, 1.0).pixels_left_out(), 3u);
  EXPECT_EQ(ReferenceImage(corner, corner, 20.0, 1.0).pixels_left_out(), 1u);

  // An error in the pixels that are left out is an error of the whole picture alone.
  Image wrong = bright;
  wrong.at(5, 5)[1] = 0.0f;
  const ReferenceImage reference(bright, bright, 9.99, 1.0);
  EXPECT_GT(reference.errors_of(wrong).mse, 1.0);
  EXPECT_EQ(reference.errors_of(wrong).relative_mse_trimmed, 0.0);
}

TEST(ReferenceImage, TheFloorIsAQuarterOfTheHalvesDifference) {
  const ReferenceImage reference(constant(0.4f), constant(0.6f), std::nullopt, 1.0);
  const double square = std::pow(static_cast<double>(0.6f) - 0.4f, 2) / 4.0;
  EXPECT_NEAR(reference.noise_floor().mse, square, error_rounding);
  EXPECT_NEAR(reference.noise_floor().relative_mse, square / (0.25 + 0.01), 1e-7);  // the mean 0.5 is a float
}

TEST(ReferenceImage, WhatIsLeftAfterTheFloorIsTheTrueError) {
  // Reference halves with σ = 0.2 (their mean: variance v = 0.02), test pictures with σ = 0.3 and a bias of 0.1: the
  // true error is 0.10.
  std::mt19937_64 random(11);
  constexpr int trials = 300;
  double sum = 0.0, squares = 0.0, relative = 0.0, raw = 0.0;
  const Image truth = constant(2.0f), biased = constant(2.1f);
  for (int i = 0; i < trials; ++i) {
    const ReferenceImage reference(noisy(truth, 0.2, random), noisy(truth, 0.2, random), std::nullopt, 1.0);
    const PictureErrors errors = reference.errors_of(noisy(biased, 0.3, random));
    const double left = errors.mse - reference.noise_floor().mse;
    sum += left, squares += left * left, raw += errors.mse;
    relative += errors.relative_mse - reference.noise_floor().relative_mse;
  }
  const double mean = sum / trials, standard_error = std::sqrt((squares / trials - mean * mean) / trials);
  EXPECT_NEAR(mean, 0.10, 4.0 * standard_error);
  EXPECT_NEAR(raw / trials, 0.12, 4.0 * standard_error + 0.0005);  // the floor scatters, too
  // Relative: with the weight w(r) = w(2)(1 − 0.9975 n + 0.7456 n²) for the noise n of r, to second order in v/r²,
  // 0.1 + 0.2·0.9975 v + 0.7456 (0.1 v + 3v²) − 0.7456 v² = 0.1061 in place of 0.10; 4σ of the trials are 1.3 %.
  EXPECT_NEAR(relative / trials, 0.1061 / 4.01, 0.013 * 0.1061 / 4.01);
}

TEST(ReferenceImage, RefusesHalvesThatDiffer) {
  EXPECT_THROW(ReferenceImage(constant(1.0f), Image(side, side + 1, 3), std::nullopt, 1.0), InputError);
  EXPECT_THROW(ReferenceImage(Image(4, 4, 3), Image(4, 4, 3), std::nullopt, 1.0), InputError);
}

BenchRequirement requirement(BenchStatistic statistic, const char* error = "rmse") {
  BenchRequirement r;
  r.statistic = statistic;
  r.error = error;
  r.method = "b";
  r.baseline = "a";
  r.views = {"v"};
  return r;
}

TEST(BenchEvaluation, EstimatesByHand) {
  const MeasuredSetting setting{
      "m", 4, {sample(1.0, 8.0, 0.03), sample(9.0, 8.0, 0.05), sample(2.0, 8.0, 0.04), sample(3.0, 8.0, 0.04)}, ""};
  EXPECT_NEAR(median_seconds(setting), 2.5, error_rounding);
  PictureErrors floor;
  floor.mse = floor.relative_mse = floor.relative_mse_trimmed = floor.one_minus_ssim = 0.015;
  // Mean 0.04, deviations −0.01, 0.01, 0, 0: standard error √(2e-4/12) = 0.00408248; left after the floor 0.025, its
  // root 0.158114.
  const ErrorEstimate root = estimate(setting, floor, error_kind("rmse"));
  EXPECT_NEAR(root.raw, 0.2, error_rounding);
  EXPECT_NEAR(root.value.value(), 0.15811388300841897, error_rounding);
  EXPECT_NEAR(root.standard_error.value(), 0.004082482904638630 / (2.0 * 0.15811388300841897), error_rounding);
  EXPECT_EQ(root.status, FloorStatus::Clear);
  EXPECT_NEAR(estimate(setting, floor, error_kind("relative_mse")).value.value(), 0.025, error_rounding);
  EXPECT_NEAR(estimate(setting, floor, error_kind("relative_mse_trimmed")).value.value(), 0.04,
              error_rounding);  // nothing taken off
  EXPECT_NEAR(estimate(setting, floor, error_kind("one_minus_ssim")).value.value(), 0.04, error_rounding);
  floor.mse = 0.025;
  EXPECT_EQ(estimate(setting, floor, error_kind("rmse")).status, FloorStatus::Near);
  floor.mse = 0.05;
  EXPECT_EQ(estimate(setting, floor, error_kind("rmse")).status, FloorStatus::Below);
  EXPECT_FALSE(estimate(setting, floor, error_kind("rmse")).value);
}

TEST(BenchEvaluation, StatisticsOfTwoMethodsByHand) {
  const MeasuredView view = two_methods();
  EXPECT_NEAR(statistic_of(requirement(BenchStatistic::Slope), view).value.value(), -0.5, error_rounding);
  EXPECT_NEAR(statistic_of(requirement(BenchStatistic::Slope, "relative_mse"), view).value.value(), -1.0,
              error_rounding);
  EXPECT_NEAR(statistic_of(requirement(BenchStatistic::Error), view).value.value(), 0.5 / 8.0, error_rounding);
  const StatisticValue ratio = statistic_of(requirement(BenchStatistic::ErrorRatio), view);
  EXPECT_NEAR(ratio.value.value(), 0.5, error_rounding);
  // Each error: relative standard error of the mean square 0.1·√(2/6), of its root half of that; two of them.
  EXPECT_NEAR(ratio.standard_error.value(), 0.5 * 0.05 * std::sqrt(2.0 / 6.0) * std::sqrt(2.0), error_rounding);
  // The error 1/8 of a at 64 s is reached by b with 16 samples, in 32 s.
  const StatisticValue time = statistic_of(requirement(BenchStatistic::TimeRatio), view);
  EXPECT_NEAR(time.value.value(), 0.5, 10 * error_rounding);
  // An error off by 1 % is reached 2 % earlier or later where it falls with the root of the time.
  EXPECT_NEAR(time.standard_error.value(), 2.0 * ratio.standard_error.value(), 10 * error_rounding);
  EXPECT_NEAR(statistic_of(requirement(BenchStatistic::CostRatio), view).value.value(), 0.5, error_rounding);
  EXPECT_NEAR(statistic_of(requirement(BenchStatistic::CostRatio, "relative_mse"), view).value.value(), 0.5,
              error_rounding);
}

TEST(BenchEvaluation, TheOtherWayRoundTheErrorIsNeverReached) {
  BenchRequirement r = requirement(BenchStatistic::TimeRatio);
  std::swap(r.method, r.baseline);
  const StatisticValue never = statistic_of(r, two_methods());
  EXPECT_FALSE(never.value);
  EXPECT_EQ(never.note, "the error is never reached");
  r.at_most = 1.0;
  EXPECT_FALSE(keeps_bounds(r, never.value));
}

TEST(BenchEvaluation, BoundsAreInclusiveAndNothingKeepsNone) {
  BenchRequirement r = requirement(BenchStatistic::Slope);
  r.at_least = -0.52;
  r.at_most = -0.48;
  for (const double inside : {-0.52, -0.5, -0.48}) EXPECT_TRUE(keeps_bounds(r, inside)) << inside;
  for (const double outside : {-0.53, -0.47}) EXPECT_FALSE(keeps_bounds(r, outside)) << outside;
  EXPECT_FALSE(keeps_bounds(r, std::nullopt));
}

TEST(BenchEvaluation, AReportOfTheView) {
  const Json view =
      to_json(evaluated(two_methods(), {{"a", "A"}, {"b", "B"}, {"c", "not used"}}, {{"rmse", 0.25}, {"rmse", 0.01}}));
  ASSERT_EQ(view["methods"].size(), 2u);
  EXPECT_NEAR(view["methods"][0]["slopes"]["rmse"]["slope"].get<double>(), -0.5, error_rounding);
  EXPECT_EQ(view["methods"][0]["points"][1]["seconds"]["longest"], 48.0);
  EXPECT_EQ(view["methods"][0]["points"][1]["seconds"]["median"], 16.0);
  EXPECT_EQ(view["methods"][0]["points"][1]["samples_per_second"], 1.0);
  EXPECT_NEAR(view["methods"][0]["times"][0]["seconds"].get<double>(), 16.0, 100 * error_rounding);
  EXPECT_EQ(view["methods"][1]["times"][0]["status"], "at_once");
  EXPECT_TRUE(view["methods"][1]["times"][1]["seconds"].is_null());
  // a at 4 s, then b at 8, 32 and 128 s: a at 16 s (error 1/4) is beaten by b at 8 s (error 1/4), a at 64 s by b at 32
  // s.
  ASSERT_EQ(view["pareto"]["rmse"].size(), 4u);
  EXPECT_EQ(view["pareto"]["rmse"][0]["method"], "a");
  EXPECT_EQ(view["pareto"]["rmse"][3]["method"], "b");
  EXPECT_TRUE(view["crossovers"].empty());
  EXPECT_EQ(view["ratios"].size(), 4u);
  EXPECT_EQ(view["ratios"][0]["baseline"], "a");
  EXPECT_EQ(view.dump().find("nan"), std::string::npos);
}

TEST(BenchEvaluation, OneBrokenRequirementFailsTheReport) {
  BenchRequirement kept = requirement(BenchStatistic::ErrorRatio), broken = kept;
  kept.id = "kept";
  kept.at_most = 0.6;
  broken.id = "broken";
  broken.at_most = 0.4;
  const std::vector<BenchRequirementResult> results = evaluated({kept, broken}, {two_methods()});
  const Json both = to_json(results);
  EXPECT_TRUE(both[0]["passed"].get<bool>());
  EXPECT_FALSE(both[1]["passed"].get<bool>());
  EXPECT_FALSE(bench_verdict(results).passed);
  EXPECT_TRUE(bench_verdict(evaluated({kept}, {two_methods()})).passed);
  EXPECT_TRUE(bench_verdict({}).passed);
}

}  // namespace
}  // namespace sturm
