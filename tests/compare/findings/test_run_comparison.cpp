#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/findings/run_comparison.h"
#include "compare/findings/study_reports.h"
#include "io/json/schema.h"

namespace sturm {
namespace {

using Kind = RunChange::Kind;
using Direction = RunChange::Direction;

/// One image with an SSIM of `value` ± `uncertainty` from `replicates`.
Json report_with(double value, double uncertainty, int replicates) {
  return {{"spec", {{"images", {{{"id", "box"}, {"replicates", replicates}}}}}},
          {"images",
           {{{"id", "box"},
             {"ray_model", "power_matrix"},
             {"metrics", {{"ssim_display", {{"value", value}, {"uncertainty", uncertainty}}}}}}}}};
}

TEST(RunComparison, HoldsADifferenceAgainstBothErrors) {
  // 0.05 apart, errors 0.006 and 0.008: 5 standard errors of the difference. So many replicates are as good as a known
  // error.
  const RunComparison c = compare_runs(report_with(0.95, 0.006, 1000000), report_with(0.90, 0.008, 1000000), 0.01);
  ASSERT_EQ(c.changes.size(), 1u);
  EXPECT_NEAR(*c.changes[0].z, -5.0, 1e-3);  // t of 1e6 degrees is a normal deviate up to t³/(4·1e6) = 3e-5
  EXPECT_NEAR(*c.changes[0].standard_error, 0.01, 1e-12);
  EXPECT_EQ(c.changes[0].direction, Direction::Worse);
  EXPECT_EQ(c.tests, 1u);
  EXPECT_NEAR(c.threshold_z, 2.575829, 1e-6);  // two-sided 1 %, from tables
}

TEST(RunComparison, FewReplicatesHaveStudentsTails) {
  // Equal errors of two replicates each: Welch's test has 2 degrees of freedom, where |t| = 5 has p = 1 − 5/√(2 + 25) =
  // 0.0377.
  const RunComparison c =
      compare_runs(report_with(0.95, 0.01, 2), report_with(0.95 - 5 * 0.01 * std::sqrt(2.0), 0.01, 2), 0.04);
  ASSERT_EQ(c.changes.size(), 1u);
  EXPECT_NEAR(*c.changes[0].z, -2.0777, 2e-3);  // two-sided 0.0377 of the normal distribution
  EXPECT_TRUE(compare_runs(report_with(0.95, 0.01, 2), report_with(0.95 - 5 * 0.01 * std::sqrt(2.0), 0.01, 2), 0.03)
                  .changes.empty());
}

TEST(RunComparison, ANumberWithoutErrorsIsNoRegression) {
  Json before = report_with(0.95, 0.0, 2), after = report_with(0.90, 0.0, 2);
  const RunComparison c = compare_runs(before, after, 0.01);
  ASSERT_EQ(c.changes.size(), 1u);
  EXPECT_EQ(c.changes[0].kind, Kind::WithoutUncertainty);
  EXPECT_EQ(c.changes[0].direction, Direction::Worse);
  EXPECT_EQ(c.regressions(), 0u);
}

TEST(RunComparison, ALostNumberIsARegression) {
  Json after = report_with(0.95, 0.01, 2);
  after["images"][0]["metrics"]["ssim_display"]["value"] = nullptr;
  EXPECT_EQ(compare_runs(report_with(0.95, 0.01, 2), after, 0.01).regressions(), 1u);
  EXPECT_EQ(compare_runs(after, report_with(0.95, 0.01, 2), 0.01).changes.at(0).kind, Kind::New);
}

TEST(RunComparison, NearerToItsPredictionIsBetter) {
  const auto report = [](double xx) -> Json {
    return {{"ellipses",
             {{"conditions", {{"replicates", 64}}},
              {"cases",
               {{{"id", "A"},
                 {"conoid", {{"covariance_rad2", {1.0, 0.0, 1.0}}}},
                 {"rays",
                  {{{"ray_model", "power_matrix"},
                    {"covariance_rad2", {xx, 0.0, 1.0}},
                    {"covariance_standard_error_rad2", {0.01, 0.01, 0.01}}}}}}}}}}};
  };
  EXPECT_EQ(compare_runs(report(1.0), report(0.5), 0.01).changes.at(0).direction, Direction::Worse);
  EXPECT_EQ(compare_runs(report(1.5), report(1.0), 0.01).changes.at(0).direction, Direction::Better);
}

TEST(RunComparison, APredictionsErrorIsHeldAgainstItsUncertainty) {
  using testing::agreement_report;
  // Standard errors of 3e-5 on both sides: 4.2e-5 of the difference. Two numbers at 1 % together: |z| > 2.806.
  EXPECT_TRUE(compare_runs(agreement_report(0.97, 4e-4), agreement_report(0.97, 5e-4), 0.01).changes.empty());  // 2.4
  const RunComparison c = compare_runs(agreement_report(0.97, 4e-4), agreement_report(0.97, 6e-4), 0.01);       // 4.7
  ASSERT_EQ(c.changes.size(), 1u);
  EXPECT_EQ(c.tests, 2u);
  EXPECT_EQ(c.changes[0].name, "prediction box, layered, whole: mean square error");
  EXPECT_NEAR(*c.changes[0].z, 2e-4 / 4.2426e-5, 1e-3);
  EXPECT_EQ(c.changes[0].direction, Direction::Worse);
  EXPECT_EQ(compare_runs(agreement_report(0.97, 6e-4), agreement_report(0.97, 4e-4), 0.01).changes.at(0).direction,
            Direction::Better);
  EXPECT_EQ(compare_runs(agreement_report(0.97, 4e-4), agreement_report(0.95, 4e-4), 0.01).changes.at(0).direction,
            Direction::Worse);
  // The same difference of three pictures each proves nothing: t = 4.7 with 4 degrees of freedom has p = 0.9 %.
  EXPECT_TRUE(compare_runs(agreement_report(0.97, 4e-4, 3), agreement_report(0.97, 6e-4, 3), 0.01).changes.empty());
}

TEST(RunComparison, OfTimesNoUncertaintyIsKnown) {
  const auto report = [](Json times_faster) {
    Json made = testing::agreement_report(0.97, 4e-4);
    made["agreement"][0]["predictions"][0]["times_faster"] = std::move(times_faster);
    return made;
  };
  const auto only_change = [&](const Json& before, const Json& after) {
    const RunComparison c = compare_runs(report(before), report(after), 0.01);
    EXPECT_EQ(c.regressions(), 0u);
    EXPECT_EQ(c.changes.size(), 1u);
    return c.changes.at(0);
  };
  const RunChange slower = only_change(20.0, 2.0);
  EXPECT_EQ(slower.name, "prediction box, layered: times faster");
  EXPECT_EQ(slower.kind, Kind::WithoutUncertainty);
  EXPECT_EQ(slower.direction, Direction::Worse);
  EXPECT_EQ(only_change(2.0, 20.0).direction, Direction::Better);
  // A smaller error, below the noise of the reference, has none: that is no evidence that got lost.
  EXPECT_EQ(only_change(20.0, nullptr).kind, Kind::Missing);
  EXPECT_EQ(only_change(20.0, nullptr).direction, Direction::Neither);
  Json gone = report(20.0);
  gone["agreement"][0]["predictions"] = Json::array();                  // but this is
  EXPECT_EQ(compare_runs(report(20.0), gone, 0.01).regressions(), 3u);  // with SSIM and mean square error
}

TEST(RunComparison, NoiseFloorsAreHeldAgainstTheirUncertainty) {
  const auto report = [](double floor, double uncertainty, int replicates) {
    Json made = testing::agreement_report(0.97, 4e-4, replicates);
    made["agreement"][0]["noise_floor"] = {{"rmse_display", floor}};
    made["agreement"][0]["noise_floor_uncertainty"] = {{"rmse_display", uncertainty}};
    return made;
  };
  // Standard errors 6e-5 and 8e-5: 1e-4 of the difference. Three numbers at 1 % together: |z| > 2.934.
  EXPECT_TRUE(compare_runs(report(0.01, 6e-5, 1000000), report(0.01025, 8e-5, 1000000), 0.01).changes.empty());
  const RunComparison c = compare_runs(report(0.01, 6e-5, 1000000), report(0.0105, 8e-5, 1000000), 0.01);
  ASSERT_EQ(c.changes.size(), 1u);
  EXPECT_EQ(c.changes[0].name, "prediction box: noise floor of rmse_display");
  EXPECT_NEAR(*c.changes[0].z, 5.0, 1e-3);
  EXPECT_EQ(c.changes[0].direction, Direction::Worse);
  EXPECT_EQ(compare_runs(report(0.0105, 8e-5, 1000000), report(0.01, 6e-5, 1000000), 0.01).changes.at(0).direction,
            Direction::Better);
  // Four pictures are two degrees of freedom in each run, four together: t = 5 has p = 0.7 %, of three numbers too
  // much.
  EXPECT_TRUE(compare_runs(report(0.01, 7e-5, 4), report(0.010495, 7e-5, 4), 0.01).changes.empty());
  // Without a known uncertainty the floor says nothing, however far it moved.
  Json before = report(0.01, 0.0, 4), after = report(0.05, 0.0, 4);
  before["agreement"][0]["noise_floor_uncertainty"] = after["agreement"][0]["noise_floor_uncertainty"] = nullptr;
  EXPECT_EQ(compare_runs(before, after, 0.01).changes.at(0).kind, Kind::WithoutUncertainty);
}

TEST(RunComparison, RadiiMayMoveByTheNoiseOfBothRuns) {
  const auto report = [](double radius) {
    Json made = testing::sin2_report(0.0, 0.4);
    for (Json& model : made["sin2_study"]["gallery"][0]["models"])
      model.update({{"radius_50_arcmin", 3.0}, {"radius_50_error_of_independent_rays_arcmin", 0.01}});
    made["sin2_study"]["gallery"][0]["models"][1]["radius_50_arcmin"] = radius;
    return made;
  };
  // Four errors of 0.01 in each run: 0.08.
  EXPECT_TRUE(compare_runs(report(3.0), report(3.079), 0.01).changes.empty());
  for (const double moved : {2.919, 3.081}) {
    const RunComparison c = compare_runs(report(3.0), report(moved), 0.01);
    ASSERT_EQ(c.changes.size(), 1u);
    EXPECT_EQ(c.changes[0].name, "sin² study, point spread circle, repaired: radius_50 [arcmin]");
    EXPECT_EQ(c.changes[0].kind, Kind::BeyondUncertainty);
    EXPECT_EQ(c.changes[0].direction, Direction::Neither);
  }
}

TEST(RunComparison, ABiasThatComesUpIsWorse) {
  using testing::sampling_report;
  const Json before = sampling_report(1e-6, 0.5, 0.1);
  EXPECT_TRUE(compare_runs(before, sampling_report(4e-6, 1.5, 0.102), 0.01).changes.empty());
  const RunComparison bias = compare_runs(before, sampling_report(1e-4, 40.0, 0.1), 0.01);
  ASSERT_EQ(bias.changes.size(), 1u);
  EXPECT_EQ(bias.changes[0].name, "sampling lens, uniform_polar_weighted, halton: mean square bias [radiance²]");
  EXPECT_EQ(bias.regressions(), 1u);
  const RunComparison noise = compare_runs(before, sampling_report(1e-6, 0.5, 0.12), 0.01);
  ASSERT_EQ(noise.changes.size(), 1u);
  EXPECT_EQ(noise.changes[0].name, "sampling lens, uniform_polar_weighted, halton: noise [radiance]");
  EXPECT_EQ(noise.regressions(), 1u);
  // Raw polar sampling is biased by design: another bias is a change, and no more.
  Json other = before;
  other["sampling_study"]["entries"][1]["mean_square_bias"] = 8e-4;
  const RunComparison by_design = compare_runs(before, other, 0.01);
  ASSERT_EQ(by_design.changes.size(), 1u);
  EXPECT_EQ(by_design.changes[0].direction, Direction::Neither);
}

TEST(RunComparison, NumbersWithoutNoiseMayMoveByRoundingOnly) {
  using testing::sin2_report;
  const Json before = sin2_report(3e-15, 0.4);
  RunComparison c = compare_runs(before, sin2_report(9e-15, 0.4), 0.01);
  EXPECT_TRUE(c.changes.empty());
  EXPECT_EQ(c.tests, 0u);
  EXPECT_EQ(c.bounded, c.numbers);
  c = compare_runs(before, sin2_report(1e-3, 0.4), 0.01);
  ASSERT_EQ(c.changes.size(), 1u);
  EXPECT_EQ(c.changes[0].kind, Kind::BeyondUncertainty);
  EXPECT_EQ(c.changes[0].name, "sin² study, matrix_vs_theory_max");
  EXPECT_FALSE(c.changes[0].z);
  EXPECT_EQ(c.regressions(), 1u);
  Json other = before;
  other["sin2_study"]["population"][0]["noticeable"] = 121;
  c = compare_runs(before, other, 0.01);
  ASSERT_EQ(c.changes.size(), 1u);
  EXPECT_EQ(c.changes[0].name, "sin² study, real eyes, sin2_radial, relaxed, 1 m: noticeable");
  EXPECT_EQ(c.changes[0].direction, Direction::Neither);
}

TEST(RunComparison, APointSpreadMayMoveByTheNoiseOfBothRuns) {
  using testing::sin2_report;
  // Two runs of theory are 0.004 apart in each report: 0.008 may be noise.
  EXPECT_TRUE(compare_runs(sin2_report(0.0, 0.4), sin2_report(0.0, 0.4079), 0.01).changes.empty());
  const RunComparison c = compare_runs(sin2_report(0.0, 0.4), sin2_report(0.0, 0.4081), 0.01);
  ASSERT_EQ(c.changes.size(), 1u);
  EXPECT_EQ(c.changes[0].name, "sin² study, point spread circle, repaired: total variation from theory");
}

TEST(RunComparison, FollowsItsSchema) {
  const Json before = report_with(0.95, 0.006, 9), after = report_with(0.5, 0.008, 9);
  const RunComparison c = compare_runs(before, after, 0.01);
  EXPECT_NO_THROW(validate(run_comparison_json(c, before, "a.json", after, "b.json"), "run_comparison", "made"));
}

TEST(RunComparison, ForeignReportsAreEmpty) {
  for (const Json& foreign :
       {Json(nullptr), Json(3), Json{{"images", "text"}}, Json{{"ellipses", {{"cases", {1, nullptr}}}}}}) {
    const RunComparison c = compare_runs(foreign, foreign, 0.01);
    EXPECT_EQ(c.numbers, 0u);
    EXPECT_TRUE(c.changes.empty());
  }
}

}  // namespace
}  // namespace sturm
