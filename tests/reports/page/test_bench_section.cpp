#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "compare/findings/bench.h"
#include "compare/findings/statistic_rule.h"
#include "compare/studies/bench/evaluation.h"
#include "compare/studies/bench/requirements.h"
#include "compare/studies/bench/two_bench_methods.h"
#include "reports/markup/markup_defects.h"
#include "reports/page/bench_page.h"
#include "reports/sections/sections.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

void add_bench(const Json& report, Statistics& out) {
  Measurements measurements;
  measure_bench(report, measurements);
  add_statistics_by_themselves(measurements, out);
}

constexpr double rounding = 1e-11;  // logarithms of numbers up to 128, a few operations

const std::vector<ErrorLevel> levels = {{"rmse", 0.25}, {"one_minus_ssim", 0.005}};

/// A report with the section of two methods, and a third that is a filtered picture: as fast as "a", with a sixteenth
/// of its squared error.
Json report_with_bench() {
  MeasuredView view = test::two_methods();
  for (const int n : {4, 16})
    view.settings.push_back({"filtered",
                             static_cast<std::uint64_t>(n),
                             {test::sample(n, n, 0.0625 / n), test::sample(n, n, 0.0625 / n)},
                             ""});
  Json of_view = to_json(evaluated(view, {{"a", "A"}, {"b", "B"}, {"filtered", "<F>", true}}, levels));
  of_view["id"] = "v";
  of_view["title"] = "a view";
  of_view["resolution"] = {2, 1};
  const Json broken = {{"id", "steep"}, {"view", "v"}, {"passed", false}},
             kept = {{"id", "flat"}, {"view", "v"}, {"passed", true}};
  return {{"bench",
           {{"title", "A race"},
            {"machine", {{"cpu", "Abacus"}, {"threads", 2}}},
            {"views", {of_view}},
            {"requirements", {broken, kept}}}}};
}

/// The ratio of `method` to the baseline in RMSE.
const Json& rmse_ratio(const Json& view, const std::string& method) {
  for (const Json& r : view.at("ratios"))
    if (r.at("method") == method && r.at("error") == "rmse") return r;
  throw std::out_of_range(method);
}

TEST(BenchSection, SettingsAreToldApartByWhatTheyChange) {
  const Json view = report_with_bench()["bench"]["views"][0];
  EXPECT_EQ(view["methods"][0]["points"][0]["setting"], "");
  EXPECT_EQ(view["methods"][0]["points"][2]["setting"], "passes 64");
  EXPECT_EQ(view["pareto"]["rmse"][3]["setting"], "passes 64");
}

TEST(BenchSection, AFilteredPictureHasRowsAndNothingElse) {
  const Json view = report_with_bench()["bench"]["views"][0];
  ASSERT_EQ(view["methods"].size(), 3u);
  EXPECT_TRUE(view["methods"][2]["biased"].get<bool>());
  EXPECT_FALSE(view["methods"][0]["biased"].get<bool>());
  EXPECT_EQ(view["methods"][2]["points"].size(), 2u);
  EXPECT_NEAR(view["methods"][2]["times"][0]["seconds"].get<double>(), 4.0, rounding);
  // It would be the whole front if it counted.
  for (const char* list : {"pareto", "crossovers", "ratios"})
    EXPECT_THAT(view[list].dump(), Not(HasSubstr("filtered"))) << list;
  EXPECT_EQ(view["pareto"]["rmse"].size(), 4u);
}

TEST(BenchSection, AtItsBestByHand) {
  // a ends at the error 1/8 after 64 s (median 64·1); b has it with 16 samples after 32 s: a is half as fast there.
  const MeasuredView view = test::two_methods();
  const ErrorKind& rmse = error_kind("rmse");
  const MethodCurve a = curve_of(view, "a", rmse), b = curve_of(view, "b", rmse);
  const auto best = at_its_best(a, b);
  ASSERT_TRUE(best);
  EXPECT_EQ(best->index, 2u);
  EXPECT_EQ(best->baseline.reach, Reach::Interpolated);
  EXPECT_NEAR(best->times_faster.value(), 0.5, rounding);
  // b's best is never reached by a, and a method without values has no best.
  EXPECT_EQ(at_its_best(b, a)->baseline.reach, Reach::Never);
  EXPECT_FALSE(at_its_best(b, a)->times_faster);
  EXPECT_FALSE(at_its_best({}, a));
  // Where the baseline's cheapest setting is there already, its time is only a bound, and no ratio comes of it.
  MethodCurve poor = a;
  for (CostPoint& point : poor.points) point.error = 2.0;
  EXPECT_EQ(at_its_best(poor, b)->baseline.reach, Reach::AtOnce);
  EXPECT_FALSE(at_its_best(poor, b)->times_faster);

  const Json report = report_with_bench();
  const Json& in_report = rmse_ratio(report["bench"]["views"][0], "b")["at_its_best"];
  EXPECT_EQ(in_report["setting"], "passes 64");
  EXPECT_EQ(in_report["baseline_status"], "never");
  EXPECT_TRUE(in_report["times_faster"].is_null());
}

TEST(BenchSection, StatisticsOfGates) {
  const Json report = report_with_bench();
  Statistics s;
  add_bench(report, s);
  EXPECT_NEAR(s.at("bench/v/a/slope/rmse").value.value(), -0.5, rounding);
  EXPECT_NEAR(s.at("bench/v/a/slope/relative_mse").value.value(), -1.0, rounding);
  EXPECT_GT(s.at("bench/v/a/slope/rmse").uncertainty.value(), 0.0);
  EXPECT_NEAR(s.at("bench/v/a/last_slope/rmse").value.value(), -0.5, rounding);
  EXPECT_NEAR(s.at("bench/v/a/last_slope/relative_mse").value.value(), -1.0, rounding);
  EXPECT_NEAR(s.at("bench/v/b/error/rmse").value.value(), 0.0625, rounding);
  EXPECT_NEAR(s.at("bench/v/b/error_ratio/rmse").value.value(), 0.5, rounding);
  EXPECT_NEAR(s.at("bench/v/b/time_ratio/rmse").value.value(), 0.5, rounding);
  // Each error: relative standard error of the mean square 0.1·√(2/6), of its root half of that; two of them; twice as
  // much of a time.
  EXPECT_NEAR(s.at("bench/v/b/error_ratio/rmse").uncertainty.value(), 0.5 * 0.05 * std::sqrt(4.0 / 6.0), rounding);
  EXPECT_NEAR(s.at("bench/v/b/time_ratio/rmse").uncertainty.value(), 0.05 * std::sqrt(4.0 / 6.0), rounding);
  EXPECT_NEAR(s.at("bench/v/a/seconds/rmse/0.25").value.value(), 16.0, rounding);
  EXPECT_FALSE(s.at("bench/v/b/times_faster/rmse").value);
  EXPECT_FALSE(s.at("bench/v/b/seconds/one_minus_ssim/0.005").value.has_value() &&
               s.at("bench/v/a/seconds/one_minus_ssim/0.005").value);
  EXPECT_EQ(s.at("bench/broken_requirements").value, 1.0);
  EXPECT_EQ(s.at("bench/broken_requirements").cases, 2u);
  EXPECT_EQ(s.at("bench/broken_requirements").worst_case, "steep, v");
  for (const auto& [name, unused] : s) EXPECT_THAT(name, Not(HasSubstr("filtered")));

  Statistics none;
  add_bench(Json::object(), none);
  EXPECT_TRUE(none.empty());
}

TEST(BenchSection, TheLastSlopeIsThatOfTheLastTwoSettings) {
  Json report = report_with_bench();
  Json& points = report["bench"]["views"][0]["methods"][0]["points"];
  points[2]["errors"]["rmse"]["value"] = 0.5 * points[1]["errors"]["rmse"]["value"].get<double>();
  Statistics s;
  add_bench(report, s);
  EXPECT_NEAR(s.at("bench/v/a/last_slope/rmse").value.value(), std::log(0.5) / std::log(4.0), rounding);
  points[2]["errors"]["rmse"]["value"] = points[1]["errors"]["rmse"]["value"];
  add_bench(report, s);
  EXPECT_NEAR(s.at("bench/v/a/last_slope/rmse").value.value(), 0.0, rounding);
  EXPECT_GT(s.at("bench/v/a/last_slope/rmse").uncertainty.value(), 0.0);
  points[2]["samples"] = 1.5 * points[1]["samples"].get<double>();  // less than a factor of two
  add_bench(report, s);
  EXPECT_FALSE(s.at("bench/v/a/last_slope/rmse").value);
}

TEST(BenchSection, TheSentenceNamesWhoIsFirst) {
  const Json sentence = bench_sentence(*bench_findings(report_with_bench()));
  ASSERT_TRUE(sentence.is_string());
  // The filtered picture would be first. Both have the error 1/4 for the first time at 8 s (b, its cheapest) and 16 s
  // (a).
  EXPECT_THAT(sentence.get<std::string>(), HasSubstr("v: RMSE 0.25: b within 8 s, a in 16 s"));
  EXPECT_THAT(sentence.get<std::string>(), HasSubstr("1 − SSIM 0.005: b in 100 s, a never"));
  EXPECT_TRUE(bench_sentence(BenchFindings{}).is_null());
}

TEST(BenchSection, ThePageShowsIt) {
  const std::string html = bench_section(report_with_bench(), std::filesystem::temp_directory_path()).markup();
  EXPECT_EQ(test::markup_defects(html), "");
  for (const char* text : {"Abacus", "A race", "a view", "SSIM 0.995", "not reached", "filtered: biased", "passes 64",
                           "Each method at its least error"})
    EXPECT_THAT(html, HasSubstr(text));
  EXPECT_TRUE(bench_section(Json::object(), "").empty());
}

}  // namespace
}  // namespace sturm
