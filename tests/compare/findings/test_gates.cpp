#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "compare/findings/gate_statistics.h"
#include "compare/findings/healthy_report.h"
#include "compare/findings/judged_report.h"
#include "compare/gates/gates.h"
#include "compare/gates/verdict.h"
#include "support/source_folder.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;
using testing::healthy_report;

const std::vector<GateSpec>& validation_gates() {
  static const std::string file = STURM_SOURCE_DIR "/configs/gates/validation.json";
  static const std::vector<GateSpec> gates = read_gates(load_json(file), file);
  return gates;
}

/// Ids of the validation gates that a report fails, against the healthy report as baseline.
std::vector<std::string> failures_of(const Json& report) {
  const Json baseline = healthy_report();
  std::vector<std::string> failed;
  for (const GateResult& gate : evaluate_gates(validation_gates(), report, &baseline))
    if (!gate.has_passed()) failed.push_back(gate.id);
  return failed;
}

Json spoilt(const std::string& pointer, const Json& value) {
  Json report = healthy_report();
  report.at(Json::json_pointer(pointer)) = value;
  return report;
}

TEST(GateStatistics, OfTheHealthyReportByHand) {
  const auto s = statistics_of(healthy_report());
  EXPECT_EQ(s.at("conoid_reference_max_relative_error").value, 5e-16);
  EXPECT_EQ(s.at("conoid_reference_max_relative_error").worst_case, "conoid_covariance");
  EXPECT_EQ(s.at("conoid_reference_max_relative_error").cases, 150u);
  EXPECT_EQ(s.at("sin2_reference_max_relative_error").value, 4e-16);
  EXPECT_EQ(s.at("matrix_vs_conoid_max_z").value, 1.5);
  EXPECT_EQ(s.at("matrix_vs_conoid_max_z").cases, 3u);
  EXPECT_EQ(s.at("thin_lens_vs_conoid_max_z").value, 0.9);  // the case without a cylinder alone
  EXPECT_EQ(s.at("thin_lens_vs_conoid_max_z").cases, 1u);
  EXPECT_EQ(s.at("sin2_vs_closed_form_max_z").value, 2.0);
  EXPECT_EQ(s.at("sin2_vs_conoid_min_z").value, 90000.0);  // the cases with a cylinder alone
  EXPECT_EQ(s.at("sin2_vs_conoid_min_z").cases, 2u);
  EXPECT_NEAR(*s.at("sin2_vs_conoid_min_relative_difference_ratio").value,
              0.26079 / (std::hypot(0.875, 0.625) / std::sqrt(17.0)), 1e-12);
  EXPECT_EQ(s.at("image_ssim_display/chart").value, 0.98);
  EXPECT_EQ(s.at("image_ssim_display_min").value, 0.97);
  EXPECT_EQ(s.at("image_ssim_display_min").worst_case, "cornell");
  EXPECT_EQ(s.at("image_ssim_display_min").uncertainty, 0.004);
  EXPECT_NEAR(*s.at("image_ssim_below_noise_floor_max").value, 0.005, 1e-12);
  EXPECT_NEAR(*s.at("image_ssim_gain_of_matrix_over_sin2_min").value, 0.04, 1e-12);
  EXPECT_EQ(s.at("image_ssim_gain_of_matrix_over_sin2_min").cases, 1u);
  EXPECT_NEAR(*s.at("image_matrix_rmse_over_noise_floor_max").value, 0.6, 1e-12);
  EXPECT_EQ(s.at("image_matrix_rmse_over_noise_floor_max").worst_case, "chart");
  EXPECT_EQ(s.at("image_matrix_rmse_over_noise_floor_max").cases, 2u);
  EXPECT_NEAR(*s.at("image_sin2_rmse_over_noise_floor_min").value, 2.0, 1e-12);
  EXPECT_EQ(s.at("image_sin2_rmse_over_noise_floor_min").cases, 1u);
  EXPECT_NEAR(*s.at("psf_matrix_centroid_max_z").value, 1.5, 1e-12);
  EXPECT_EQ(s.at("psf_matrix_centroid_max_z").cases, 4u);  // x and y of one spot, and of all together
  EXPECT_NEAR(*s.at("image_light_max_deviation").value, 0.0005, 1e-12);
  EXPECT_EQ(s.at("image_light_max_deviation").uncertainty, 0.0004);
  EXPECT_NEAR(*s.at("image_shift_max_px").value, 0.05, 1e-12);
  EXPECT_EQ(s.at("image_shift_max_px").cases, 2u);
  EXPECT_EQ(s.at("mutation_min_gates").value, 1.0);
  EXPECT_EQ(s.at("must_fail_min_value_over_bound").value, 10.0);
  EXPECT_EQ(s.at("must_fail_min_value_over_bound").worst_case, "double_pupil");
}

TEST(GateStatistics, RelativeDifferenceCountsXyTwice) {
  Json report = healthy_report();
  Json& c = report["ellipses"]["cases"][0];
  c["conoid"]["covariance_rad2"] = {2.0, 1.0, 2.0};            // norm² 4 + 2 + 4
  c["sin2_closed_form"]["covariance_rad2"] = {2.0, 0.5, 2.0};  // difference² 2·0.25
  EXPECT_NEAR(*statistics_of(report).at("sin2_vs_conoid_max_relative_difference_ratio").value,
              0.26079 / std::sqrt(0.05), 1e-12);
}

TEST(GateStatistics, PsfIsMeasuredAlongThePredictedAxes) {
  // 12 × 6 arcmin turned by 90°: along the predicted major axis only 6 are left
  const auto turned = statistics_of(spoilt("/psfs/0/measured/orientation_deg", 120.0 - 180.0));
  EXPECT_NEAR(*turned.at("psf_matrix_axis_max_relative").value, (12.03 - 6.0) / 6.0, 1e-9);
  // a circle may have any angle
  Json round = healthy_report();
  round["psfs"][0]["predicted"] = {{"semi_axes_arcmin", {8.0, 8.0}}, {"orientation_deg", nullptr}};
  round["psfs"][0]["measured"] = {
      {"semi_axes_arcmin", {8.02, 7.98}}, {"orientation_deg", 77.0}, {"standard_error_arcmin", {0.02, 0.02}}};
  EXPECT_LT(*statistics_of(round).at("psf_matrix_axis_max_z").value, 1.01);
}

TEST(GateStatistics, WhatAllSpotsHaveInCommonCountsToo) {
  // A pixel of 0.5 arcmin: +3 px ± 2 px and +5 px ± 2 px are 1.5 σ and 2.5 σ each, and 4 px ± √2 px together.
  Json report = healthy_report();
  report["psfs"].push_back(report["psfs"][0]);
  report["psfs"][1]["id"] = "other";
  for (Json& psf : report["psfs"]) {
    psf["measured"]["centroid_standard_error_arcmin"] = {1.0, 1.0};
    psf["measured"]["centroid_arcmin"] = {1.5, 0.0};
  }
  report["psfs"][1]["measured"]["centroid_arcmin"] = {2.5, 0.0};
  const Statistic together = statistics_of(report).at("psf_matrix_centroid_max_z");
  EXPECT_NEAR(*together.value, 4.0 / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(together.worst_case, "all spots together, x");
  EXPECT_EQ(together.cases, 6u);
  // In opposite directions they have nothing in common (+3 px and −5 px: −1 px), and the worse one alone counts.
  report["psfs"][1]["measured"]["centroid_arcmin"] = {-2.5, 0.0};
  EXPECT_NEAR(*statistics_of(report).at("psf_matrix_centroid_max_z").value, 2.5, 1e-12);
  // An error twice as large has a quarter of the weight: (3 + 5/4)/(5/4) px ± 2/√(5/4) px; downwards as upwards.
  report["psfs"][1]["measured"]["centroid_arcmin"] = {0.0, 2.5};
  report["psfs"][1]["measured"]["centroid_standard_error_arcmin"] = {2.0, 2.0};
  report["psfs"][0]["measured"]["centroid_arcmin"] = {0.0, 1.5};
  const double down = (3.0 + 5.0 / 4.0) / (5.0 / 4.0) / (2.0 / std::sqrt(5.0 / 4.0));
  EXPECT_NEAR(*statistics_of(report).at("psf_matrix_centroid_max_z").value, down, 1e-12);
  // Spots with larger pixels are displaced by fewer of them: 1.5 arcmin are 1.5 px ± 1 px there, four times the weight.
  report["psfs"][1] = report["psfs"][0];
  report["psfs"][1]["pixel_arcmin"] = 1.0;
  EXPECT_NEAR(*statistics_of(report).at("psf_matrix_centroid_max_z").value,
              (3.0 / 4.0 + 1.5) / std::sqrt(1.0 / 4.0 + 1.0), 1e-12);
  // A spot without a number leaves none.
  report["psfs"][1]["measured"]["centroid_arcmin"] = nullptr;
  EXPECT_FALSE(statistics_of(report).at("psf_matrix_centroid_max_z").value);
}

TEST(GateStatistics, ShortAxisOfAPsfHasAZButNoRelativeError) {
  Json line = healthy_report();
  line["psfs"][0]["predicted"]["semi_axes_arcmin"] = {12.0, 0.0};
  line["psfs"][0]["measured"]["semi_axes_arcmin"] = {12.0, 0.1};
  line["psfs"][0]["measured"]["orientation_deg"] = 30.0;
  EXPECT_NEAR(*statistics_of(line).at("psf_matrix_axis_max_relative").value, 0.0, 1e-12);
  // the pixel grid alone makes up to √0.2 px = 0.22 arcmin of a line
  EXPECT_NEAR(*statistics_of(line).at("psf_matrix_axis_max_z").value, 0.1 / std::hypot(0.01, std::sqrt(0.2) * 0.5),
              1e-9);
  line["psfs"][0]["measured"]["semi_axes_arcmin"] = {12.0, 2.0};
  EXPECT_GT(*statistics_of(line).at("psf_matrix_axis_max_z").value, 5.0);
  line["psfs"][0]["pixel_arcmin"] = 20.0;  // nothing is resolved: no evidence
  EXPECT_FALSE(statistics_of(line).at("psf_matrix_axis_max_relative").value);
}

TEST(GateStatistics, OneMissingNumberSpoilsTheStatisticAndIsNamed) {
  const auto s =
      statistics_of(spoilt("/ellipses/cases/1/rays/0/against_conoid/z_max", nullptr)).at("matrix_vs_conoid_max_z");
  EXPECT_FALSE(s.value);
  EXPECT_EQ(s.cases, 3u);
  EXPECT_EQ(s.worst_case, "A|inf|4 mm");
}

TEST(GateStatistics, OfAnEmptyReportAreAllWithoutValue) {
  for (const Json& report : {Json::object(), Json(nullptr), Json::array(), Json{{"ellipses", 3}, {"images", "none"}},
                             Json{{"psfs", {1, nullptr}}}})
    for (const auto& [name, statistic] : statistics_of(report)) EXPECT_FALSE(statistic.value) << name;
}

TEST(Gates, HealthyReportPassesAll) {
  EXPECT_THAT(failures_of(healthy_report()), ::testing::IsEmpty());
}

struct Spoilt {
  const char *pointer, *gate;
  Json value;
};

class EachGate : public ::testing::TestWithParam<Spoilt> {};

TEST_P(EachGate, RejectsTheReportThatItIsMadeFor) {
  EXPECT_THAT(failures_of(spoilt(GetParam().pointer, GetParam().value)), ::testing::ElementsAre(GetParam().gate));
}

const std::vector<Spoilt> spoilt_reports = {
    Spoilt{"/reference/max_relative_error/conoid_semi_axes", "conoid_is_the_reference", 1e-9},
    Spoilt{"/reference/max_relative_error/sin2_closed_form", "sin2_closed_form_is_the_reference", nullptr},
    Spoilt{"/ellipses/cases/0/rays/0/against_conoid/z_max", "matrix_equals_conoid", 6.1},
    Spoilt{"/ellipses/cases/2/rays/0/against_conoid/relative_frobenius", "matrix_equals_conoid_relative", 1.1e-4},
    Spoilt{"/ellipses/cases/2/rays/2/against_conoid/z_max", "thin_lens_equals_conoid_without_cylinder", 7.0},
    Spoilt{"/ellipses/cases/0/rays/1/against_closed_form/z_max", "sin2_equals_its_closed_form", 8.0},
    Spoilt{"/ellipses/cases/0/rays/1/against_closed_form/relative_frobenius", "sin2_equals_its_closed_form_relative",
           1e-3},
    Spoilt{"/ellipses/cases/1/rays/1/against_conoid/z_max", "sin2_differs_from_conoid", 3.9},
    Spoilt{"/ellipses/cases/1/rays/1/against_conoid/relative_frobenius", "sin2_difference_is_not_less_than_predicted",
           0.25},
    Spoilt{"/ellipses/cases/1/rays/1/against_conoid/relative_frobenius", "sin2_difference_is_not_more_than_predicted",
           0.27},
    Spoilt{"/psfs/0/measured/semi_axes_arcmin/1", "psf_equals_conoid", 5.89},
    Spoilt{"/psfs/0/measured/centroid_arcmin/0", "psf_is_in_its_place", -0.101},
    Spoilt{"/images/2/metrics/light_ratio/value", "image_keeps_its_light", 1.0041},
    Spoilt{"/images/0/metrics/light_ratio/value", "image_keeps_its_light", 0.9959},
    Spoilt{"/images/0/metrics/shift_x_px/value", "image_is_in_its_place", -0.16},
    Spoilt{"/images/2/metrics/shift_y_px/value", "image_is_in_its_place", 0.16},
    Spoilt{"/gate_power/mutations/0/caught_by", "every_mutation_is_noticed", Json::array()},
    Spoilt{"/images/0/metrics/ssim_display/value", "image_equals_prediction", 0.949},
    Spoilt{"/images/2/metrics/rmse_linear", "image_differs_by_noise_alone", 0.0151},
    Spoilt{"/images/0/noise_floor/rmse_linear", "image_differs_by_noise_alone", 0.0},
    Spoilt{"/images/1/metrics/rmse_linear", "image_tells_ray_models_apart", 0.019},
    Spoilt{"/images/1/metrics/ssim_display/value", "image_prefers_wavefront_theory", 0.971},
    Spoilt{"/images/2/metrics/ssim_display/value", "image_as_in_baseline", 0.956}};

INSTANTIATE_TEST_SUITE_P(Validation, EachGate, ::testing::ValuesIn(spoilt_reports), [](const auto& tested) {
  return std::string(tested.param.gate) + "_" + std::to_string(tested.index);
});

TEST(Gates, EveryValidationGateHasAReportThatItRejects) {
  std::set<std::string> rejecting = {"psf_equals_conoid_relative"};  // together with others: the next test
  for (const Spoilt& s : spoilt_reports) rejecting.insert(s.gate);
  for (const GateSpec& gate : validation_gates()) EXPECT_EQ(rejecting.count(gate.id), 1u) << gate.id;
}

TEST(Gates, RejectGrosslyWrongPsfs) {
  EXPECT_THAT(failures_of(spoilt("/psfs/0/measured/orientation_deg", -30.0)),
              ::testing::ElementsAre("psf_equals_conoid", "psf_equals_conoid_relative"));
}

TEST(Gates, AMissingSectionFailsAllItsGates) {
  for (const char* section : {"reference", "ellipses", "psfs", "images", "gate_power"}) {
    Json report = healthy_report();
    report.erase(section);
    EXPECT_THAT(failures_of(report), ::testing::Not(::testing::IsEmpty())) << section;
  }
  EXPECT_EQ(failures_of(Json::object()).size(), validation_gates().size());
}

TEST(Gates, ACaseWithoutTheRayModelFails) {
  Json report = healthy_report();
  report["ellipses"]["cases"][2]["rays"].erase(0);
  EXPECT_THAT(failures_of(report), ::testing::ElementsAre("matrix_equals_conoid", "matrix_equals_conoid_relative"));
}

TEST(Gates, ResultsCarryWhatTheReportShows) {
  const Json gates = to_json(evaluate_gates(validation_gates(), healthy_report(), nullptr));
  const Json& matrix = gates[2];
  EXPECT_EQ(matrix["id"], "matrix_equals_conoid");
  EXPECT_EQ(matrix["kind"], "upper_bound");
  EXPECT_EQ(matrix["value"], 1.5);
  EXPECT_EQ(matrix["bound"], 5.0);
  EXPECT_EQ(matrix["level"], 0.00014);
  EXPECT_EQ(matrix["tolerance"]["value"], 0.0);
  EXPECT_GT(matrix["noise"]["standard_deviation"], 0.0);
  EXPECT_EQ(matrix["unit"], "σ");
  EXPECT_EQ(matrix["cases"], 3);
  EXPECT_EQ(matrix["uncertainty"], nullptr);
  EXPECT_FALSE(matrix["reason"].get<std::string>().empty());
}

GateSpec gate(const std::string& statistic, GateKind kind, double bound, const std::string& unit = "") {
  return {.id = "id",
          .title = "title",
          .statistic = statistic,
          .kind = kind,
          .bound = bound,
          .unit = unit,
          .reason = "reason",
          .calibration = {}};
}

GateResult evaluated(const GateSpec& spec, const Json& report, const Json* baseline = nullptr) {
  return evaluate_gates(std::span(&spec, 1), report, baseline)[0];
}

TEST(Gates, UnknownStatisticFails) {
  const GateResult result = evaluated(gate("no_such_thing", GateKind::AtMost, 1e9), healthy_report());
  EXPECT_EQ(result.passed, false);
  EXPECT_EQ(result.value, std::nullopt);
  EXPECT_EQ(result.cases, 0u);
  EXPECT_THAT(result.worst_case, HasSubstr("no_such_thing"));
  EXPECT_EQ(evaluated(gate("no_such_thing/*", GateKind::AtMost, 1e9), healthy_report()).passed, false);
}

TEST(Gates, BoundsThemselvesPassExceptForMutants) {
  const Json report = healthy_report();
  EXPECT_EQ(evaluated(gate("matrix_vs_conoid_max_z", GateKind::AtMost, 1.5), report).passed, true);
  EXPECT_EQ(evaluated(gate("image_ssim_display_min", GateKind::AtLeast, 0.97), report).passed, true);
  EXPECT_EQ(evaluated(gate("image_ssim_display_min", GateKind::AtLeast, 0.971), report).passed, false);
  EXPECT_EQ(evaluated(gate("must_fail/double_pupil", GateKind::MustFail, 0.05), report).passed, false);
  EXPECT_EQ(evaluated(gate("must_fail/double_pupil", GateKind::MustFail, 0.04), report).kind, GateKind::MustFail);
}

TEST(Gates, PatternTakesTheWorst) {
  const GateResult lowest = evaluated(gate("image_ssim_display/*", GateKind::AtLeast, 0.975), healthy_report());
  EXPECT_EQ(lowest.passed, false);
  EXPECT_EQ(lowest.worst_case, "cornell");
  EXPECT_EQ(lowest.cases, 2u);
  EXPECT_EQ(lowest.kind, GateKind::AtLeast);
  EXPECT_EQ(evaluated(gate("image_ssim_display/*", GateKind::AtMost, 0.975), healthy_report()).worst_case, "chart");
}

TEST(Gates, BaselineInStandardErrors) {
  const Json baseline = healthy_report(), now = spoilt("/images/0/metrics/ssim_display/value", 0.95);
  const GateResult result = evaluated(gate("image_ssim_display/*", GateKind::Baseline, 3.0, "σ"), now, &baseline);
  EXPECT_NEAR(result.value.value(), 0.02 / std::hypot(0.004, 0.004), 1e-9);
  EXPECT_EQ(result.passed, false);
  EXPECT_EQ(result.kind, GateKind::Baseline);
  EXPECT_EQ(result.worst_case, "cornell: 0.95, baseline 0.97");
  EXPECT_EQ(evaluated(gate("image_ssim_display/*", GateKind::Baseline, 4.0, "σ"), now, &baseline).passed, true);
  // a better image is no failure: the value is negative then
  EXPECT_LT(evaluated(gate("image_ssim_display/cornell", GateKind::Baseline, 1.0, "σ"), baseline, &now).value.value(),
            -3.0);
  EXPECT_EQ(evaluated(gate("image_ssim_display/*", GateKind::Baseline, 1.0, "σ"), baseline, &now).passed, true);
  // without an uncertainty there is no σ
  EXPECT_EQ(evaluated(gate("matrix_vs_conoid_max_z", GateKind::Baseline, 1e9, "σ"), now, &baseline).passed, false);
}

/// The healthy report by an experiment whose images have `replicates`, with cornell's SSIM and its error.
Json measured_by(int replicates, double ssim, double error) {
  Json report = spoilt("/images/0/metrics/ssim_display", {{"value", ssim}, {"uncertainty", error}});
  report["spec"]["images"] = {{{"id", "cornell"}, {"replicates", replicates}},
                              {{"id", "chart"}, {"replicates", replicates}}};
  return report;
}

TEST(Gates, BaselineTellsARegressionFromNoise) {
  const GateSpec spec = gate("image_ssim_display/cornell", GateKind::Baseline, 4.0, "σ");
  const auto passes = [&](const Json& now, const Json& before) { return evaluated(spec, now, &before).passed == true; };
  // 5 standard errors of the difference: t with 6 degrees of freedom exceeds that by chance once in 800 runs (two-sided
  // 0.00245), no more than a normal deviate exceeds 3.03. What is noise with 4 replicates is a regression with 64.
  const Json before = measured_by(4, 0.97, 0.001), fallen = measured_by(4, 0.97 - 5.0 * std::sqrt(2.0) * 0.001, 0.001);
  EXPECT_NEAR(evaluated(spec, fallen, &before).value.value(), 3.03, 0.005);
  EXPECT_TRUE(passes(fallen, before));
  EXPECT_FALSE(passes(measured_by(64, 0.97 - 5.0 * std::sqrt(2.0) * 0.001, 0.001), measured_by(64, 0.97, 0.001)));
  // A fall of 12 standard errors (0.017 of SSIM) is one with 4 replicates, too; a rise never is.
  EXPECT_FALSE(passes(measured_by(4, 0.97 - 12.0 * std::sqrt(2.0) * 0.001, 0.001), before));
  EXPECT_TRUE(passes(measured_by(4, 0.97 + 12.0 * std::sqrt(2.0) * 0.001, 0.001), before));
  // The same run again.
  EXPECT_EQ(evaluated(spec, before, &before).value, 0.0);
}

TEST(Gates, BaselineTakesTheDegreesThatAnImageStates) {
  // Four replicates whose error is known from many parts of the picture: 5 standard errors of the difference with 90
  // degrees of freedom are a normal deviate of 4.68, a regression.
  const GateSpec spec = gate("image_ssim_display/cornell", GateKind::Baseline, 4.0, "σ");
  Json before = measured_by(4, 0.97, 0.001), fallen = measured_by(4, 0.97 - 5.0 * std::sqrt(2.0) * 0.001, 0.001);
  before["images"][0]["metrics"]["ssim_display"]["degrees"] = 45.0;
  // Known so well on one side alone: Satterthwaite's 4/(1/45 + 1/3) = 11.25 degrees, a deviate of 3.556.
  EXPECT_NEAR(evaluated(spec, fallen, &before).value.value(), 3.556, 0.001);
  fallen["images"][0]["metrics"]["ssim_display"]["degrees"] = 45.0;
  EXPECT_NEAR(evaluated(spec, fallen, &before).value.value(), 4.68, 0.005);
  EXPECT_EQ(evaluated(spec, fallen, &before).passed, false);
  // Zero degrees say that there was no noise to measure: the replicates count.
  for (Json* report : {&before, &fallen}) (*report)["images"][0]["metrics"]["ssim_display"]["degrees"] = 0.0;
  EXPECT_NEAR(evaluated(spec, fallen, &before).value.value(), 3.03, 0.005);
}

TEST(Gates, BaselineThatIsMissingOrHasOtherImagesFails) {
  const Json now = healthy_report();
  const GateSpec spec = gate("image_ssim_display/*", GateKind::Baseline, 1.0);
  const Json null;
  EXPECT_EQ(evaluated(spec, now, &now).passed, true);
  EXPECT_EQ(evaluated(spec, now, nullptr).passed, false);
  EXPECT_EQ(evaluated(spec, now, &null).passed, false);
  Json fewer = now;
  fewer["images"].erase(2);
  EXPECT_EQ(evaluated(spec, now, &fewer).passed, false);
  EXPECT_EQ(evaluated(spec, fewer, &now).passed, false);
}

GateResult outcome(const char* id, std::optional<bool> passed) {
  GateResult result;
  result.id = id;
  result.passed = passed;
  return result;
}

TEST(Verdict, CountsAndNames) {
  const std::vector<GateResult> good = {outcome("a", true), outcome("b", true)};
  EXPECT_EQ(to_json(verdict_of(good)), (Json{{"passed", true}, {"sentence", "2 of 2 gates passed."}}));
  const std::vector<GateResult> bad = {outcome("a", false), outcome("b", true), outcome("c", std::nullopt)};
  EXPECT_EQ(to_json(verdict_of(bad)), (Json{{"passed", false}, {"sentence", "1 of 3 gates passed; failed: a, c."}}));
  EXPECT_EQ(verdict_of({}).passed, std::nullopt);
}

}  // namespace
}  // namespace sturm
