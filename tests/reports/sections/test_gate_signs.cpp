#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/gates/gates.h"
#include "reports/markup/escaped.h"
#include "reports/sections/sections.h"
#include "reports/text/markdown.h"

namespace sturm {
namespace {

constexpr double bound = 5.0, baseline = 100.0;

/// A gate on a statistic that is `value`; the value of a baseline gate is how far it has fallen.
GateResult evaluated(GateKind kind, double value) {
  const auto statistics = [](double s) { return Statistics{{"s", {s, std::nullopt, 1, "case"}}}; };
  const Statistics now = statistics(kind == GateKind::Baseline ? baseline - value : value),
                   before = statistics(baseline);
  const std::vector<GateSpec> gates = {
      {.id = "g", .title = "A gate", .statistic = "s", .kind = kind, .bound = bound, .unit = "u", .reason = "r"}};
  return evaluate_gates(gates, now, &before).at(0);
}

/// The sign of the values that pass, found by trying them.
std::string sign_by_trial(GateKind kind) {
  const auto passes = [&](double value) { return evaluated(kind, value).has_passed(); };
  EXPECT_EQ(evaluated(kind, bound - 1.0).value, bound - 1.0);
  EXPECT_NE(passes(bound - 1.0), passes(bound + 1.0));
  if (passes(bound - 1.0)) return passes(bound) ? "≤" : "<";
  return passes(bound) ? "≥" : ">";
}

/// The cell before the last one of the gate's row: its bound.
std::string bound_on_the_page(const Json& gates) {
  const std::string html = gates_section({{"gates", gates}}).markup();
  const std::size_t row = html.find("<tbody>"), last = html.rfind("<td", html.find("</tr>", row)),
                    cell = html.rfind("<td", last - 1), begin = html.find('>', cell) + 1;
  return html.substr(begin, html.find("</td>", begin) - begin);
}

std::string bound_in_markdown(const Json& gates) {
  const std::string text = report_markdown(Json::object(), read_gate_results({{"gates", gates}}), {});
  const std::size_t last = text.rfind(" | case"), begin = text.rfind("| ", last - 1) + 2;
  return text.substr(begin, last - begin);
}

class GateSigns : public ::testing::TestWithParam<GateKindEntry> {};

TEST_P(GateSigns, PageAndMarkdownShowWhatIsTested) {
  const GateKind kind = GetParam().kind;
  const std::string shown = sign_by_trial(kind) + " 5 u";
  const Json gates = to_json(std::vector{evaluated(kind, 7.0)});
  EXPECT_EQ(bound_on_the_page(gates), escaped(shown));
  EXPECT_EQ(bound_in_markdown(gates), shown);
}

INSTANTIATE_TEST_SUITE_P(OfEachKind, GateSigns, ::testing::ValuesIn(gate_kinds),
                         [](const auto& gate) { return std::string(gate.param.file_word); });

TEST(GateSign, AnUnknownKindHasNone) {
  Json gates = to_json(std::vector{evaluated(GateKind::AtMost, 7.0)});
  gates[0]["kind"] = "of tomorrow";
  EXPECT_EQ(bound_on_the_page(gates), "5 u");
  EXPECT_EQ(bound_in_markdown(gates), "5 u");
}

}  // namespace
}  // namespace sturm
