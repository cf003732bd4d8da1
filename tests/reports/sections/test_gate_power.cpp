#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compare/findings/gate_power.h"
#include "compare/findings/gate_statistics.h"
#include "compare/findings/healthy_report.h"
#include "reports/markup/markup_defects.h"
#include "reports/sections/sections.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;
using testing::healthy_report;

GateSpec at_most(const char* id, const char* statistic, double bound, std::optional<double> level) {
  return {.id = id,
          .title = "t",
          .statistic = statistic,
          .kind = GateKind::AtMost,
          .bound = bound,
          .unit = "",
          .reason = "r",
          .calibration = GateCalibration{level, {0.0, "r"}, {1.0, "s"}}};
}

/// The healthy report, with a mutation that spoils the rays of one case and one that spoils a spot and an image.
Json with_patches() {
  Json report = healthy_report();
  Json rays = report["ellipses"]["cases"][1]["rays"];
  rays[0]["against_conoid"]["z_max"] = 30.0;
  report["ellipses"]["cases"][1]["mutated"]["long"] = {{"rays", rays}};
  report["psfs"][0]["mutated"]["moved"]["measured"]["centroid_arcmin"] = {0.26, 0.0};
  report["images"][2]["mutated"]["moved"]["metrics"]["shift_x_px"] = {{"value", 0.5}};
  return report;
}

TEST(MutatedReport, PatchesOneMutationAndForgetsTheOthers) {
  const Json report = with_patches(), longer = mutated_report(report, "long"), moved = mutated_report(report, "moved");
  EXPECT_EQ(statistics_of(longer).at("matrix_vs_conoid_max_z").value, 30.0);
  EXPECT_EQ(longer["psfs"], healthy_report()["psfs"]);
  EXPECT_EQ(moved["ellipses"], healthy_report()["ellipses"]);
  EXPECT_NEAR(*statistics_of(moved).at("psf_matrix_centroid_max_z").value, 13.0, 1e-12);
  EXPECT_EQ(moved["psfs"][0]["measured"]["semi_axes_arcmin"],
            healthy_report()["psfs"][0]["measured"]["semi_axes_arcmin"]);
  EXPECT_EQ(mutated_report(report, "unheard of"), healthy_report());
  Json dropped = report;
  drop_mutated(dropped);
  EXPECT_EQ(dropped, healthy_report());
}

TEST(MutatedReport, OfAnEmptyReportIsEmpty) {
  EXPECT_EQ(mutated_report(Json::object(), "long"), Json::object());
  EXPECT_EQ(mutated_report(Json{{"psfs", "none"}, {"images", {1, nullptr}}}, "long"),
            (Json{{"psfs", "none"}, {"images", {1, nullptr}}}));
}

TEST(GatePower, NamesTheGatesThatNotice) {
  const std::vector<GateSpec> gates = {at_most("z", "matrix_vs_conoid_max_z", 5.0, 1e-3),
                                       at_most("shift", "image_shift_max_px", 0.1, 2e-3),
                                       at_most("fails anyway", "image_shift_max_px", 0.0, 0.0)};
  const std::vector<MutationName> mutations = {
      {"long", "an axis"}, {"moved", "a picture"}, {"nothing", "no patch at all"}};
  const Json power = gate_power(gates, with_patches(), mutations, Json(nullptr));
  EXPECT_EQ(power["gates"], 3);
  EXPECT_NEAR(power["false_alarms_per_run"].get<double>(), 3e-3, 1e-15);
  ASSERT_EQ(power["mutations"].size(), 3u);
  EXPECT_EQ(power["mutations"][0]["what"], "an axis");
  EXPECT_EQ(power["mutations"][0]["caught_by"],
            (Json{{{"gate", "z"}, {"value", 30.0}, {"honest_value", 1.5}, {"bound", 5.0}, {"unit", ""}}}));
  ASSERT_EQ(power["mutations"][1]["caught_by"].size(), 1u);
  EXPECT_EQ(power["mutations"][1]["caught_by"][0]["gate"], "shift");  // a gate that fails anyway has noticed nothing
  EXPECT_TRUE(power["mutations"][2]["caught_by"].empty());
  EXPECT_EQ(statistics_of({{"gate_power", power}}).at("mutation_min_gates").value, 0.0);
  EXPECT_EQ(statistics_of({{"gate_power", power}}).at("mutation_min_gates").worst_case, "nothing");
}

TEST(GatePower, PageShowsWhoNoticedWhat) {
  const std::vector<GateSpec> gates = {at_most("z", "matrix_vs_conoid_max_z", 5.0, 1e-3)};
  const std::vector<MutationName> mutations = {{"long_axis", "an axis < another"}, {"nothing", "no patch at all"}};
  Json patched = with_patches();
  patched["ellipses"]["cases"][1]["mutated"]["long_axis"] = patched["ellipses"]["cases"][1]["mutated"]["long"];
  const std::string html =
      gate_power_section({{"gate_power", gate_power(gates, patched, mutations, Json(nullptr))}}).markup();
  EXPECT_EQ(test::markup_defects(html), "");
  EXPECT_THAT(html, HasSubstr("<code>long_axis</code>"));
  EXPECT_THAT(html, HasSubstr("an axis &lt; another"));
  EXPECT_THAT(html, HasSubstr("<strong class=\"mark fail\">none</strong>"));  // nobody noticed "nothing"
  EXPECT_THAT(html, HasSubstr("<span class=\"mark pass\">30.0</span>"));
  EXPECT_THAT(html, HasSubstr("false alarms in a run"));
  EXPECT_EQ(gate_power_section(healthy_report()).markup().find("false alarms"), std::string::npos);  // no levels
  EXPECT_TRUE(gate_power_section(Json::object()).empty());
}

TEST(GatePower, ASumWithoutALevelIsNone) {
  const std::vector<GateSpec> unknown = {at_most("a", "s", 1.0, 1e-3), at_most("b", "s", 1.0, std::nullopt)};
  EXPECT_TRUE(gate_power(unknown, healthy_report(), {}, Json(nullptr))["false_alarms_per_run"].is_null());
  GateSpec plain = unknown[0];
  plain.calibration.reset();
  EXPECT_TRUE(gate_power(std::span(&plain, 1), healthy_report(), {}, Json(nullptr))["false_alarms_per_run"].is_null());
}

}  // namespace
}  // namespace sturm
