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

/// What a mutation makes of the healthy report: of the rays of one case, or of a spot and an image, or of nothing.
Json longer() {
  Json report = healthy_report();
  report["ellipses"]["cases"][1]["rays"][0]["against_conoid"]["z_max"] = 30.0;
  return report;
}

Json moved() {
  Json report = healthy_report();
  report["psfs"][0]["measured"]["centroid_arcmin"] = {0.26, 0.0};
  report["images"][2]["metrics"]["shift_x_px"] = {{"value", 0.5}};
  return report;
}

MutatedStatistics with(const char* id, const char* what, const Json& report) {
  return {id, what, statistics_of(report)};
}

Json with_power(std::span<const GateSpec> gates, const std::vector<MutatedStatistics>& mutated) {
  return {{"gate_power", to_json(gate_power(gates, statistics_of(healthy_report()), mutated, nullptr))}};
}

TEST(GatePower, NamesTheGatesThatNotice) {
  const std::vector<GateSpec> gates = {
      at_most("z", "matrix_vs_conoid_max_z", 5.0, 1e-3), at_most("shift", "image_shift_max_px", 0.1, 2e-3),
      at_most("spot", "psf_matrix_centroid_max_z", 5.0, 0.0), at_most("fails anyway", "image_shift_max_px", 0.0, 0.0)};
  const std::vector<MutatedStatistics> mutated = {with("long", "an axis", longer()),
                                                  with("moved", "a picture", moved()),
                                                  with("nothing", "nothing at all", healthy_report())};
  const GatePower power = gate_power(gates, statistics_of(healthy_report()), mutated, nullptr);
  EXPECT_EQ(power.gates, 4u);
  EXPECT_NEAR(power.false_alarms_per_run.value(), 3e-3, 1e-15);
  ASSERT_EQ(power.mutations.size(), 3u);
  EXPECT_EQ(power.mutations[0].what, "an axis");
  EXPECT_EQ(to_json(power)["mutations"][0]["caught_by"],
            Json::array({{{"gate", "z"}, {"value", 30.0}, {"honest_value", 1.5}, {"bound", 5.0}, {"unit", ""}}}));
  ASSERT_EQ(power.mutations[1].caught_by.size(), 2u);
  EXPECT_EQ(power.mutations[1].caught_by[0].gate, "shift");  // a gate that fails anyway has noticed nothing
  EXPECT_EQ(power.mutations[1].caught_by[1].gate, "spot");
  EXPECT_NEAR(power.mutations[1].caught_by[1].value.value(), 13.0, 1e-12);
  EXPECT_TRUE(power.mutations[2].caught_by.empty());
  EXPECT_EQ(statistics_of(with_power(gates, mutated)).at("mutation_min_gates").value, 0.0);
  EXPECT_EQ(statistics_of(with_power(gates, mutated)).at("mutation_min_gates").worst_case, "nothing");
}

TEST(GatePower, PageShowsWhoNoticedWhat) {
  const std::vector<GateSpec> gates = {at_most("z", "matrix_vs_conoid_max_z", 5.0, 1e-3)};
  const std::string html = gate_power_section(with_power(gates, {with("long_axis", "an axis < another", longer()),
                                                                 with("nothing", "nothing at all", healthy_report())}))
                               .markup();
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
  EXPECT_FALSE(gate_power(unknown, {}, {}, nullptr).false_alarms_per_run);
  GateSpec plain = unknown[0];
  plain.calibration.reset();
  EXPECT_FALSE(gate_power(std::span(&plain, 1), {}, {}, nullptr).false_alarms_per_run);
}

}  // namespace
}  // namespace sturm
