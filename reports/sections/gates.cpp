#include <algorithm>
#include <vector>

#include "compare/findings/must_fail.h"
#include "compare/gates/gate_result.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

bool proves_that_gates_fail(const GateResult& gate) {
  return gate.kind == GateKind::MustFail;
}

/// 0 failures, 1 gates, 2 gates that show that gates can fail.
int reading_order(const GateResult& gate) {
  return !gate.has_passed() ? 0 : proves_that_gates_fail(gate) ? 2 : 1;
}

Html bound_html(const GateResult& gate) {
  if (!gate.bound) return absent_html();
  const Html sign = gate.kind ? text(sign_of(entry_of(*gate.kind).passing)) + " "_html : Html();
  return sign + exact_html(gate.bound) + unit_html(gate.unit);
}

Html worst_case_html(const GateResult& gate) {
  Html html = text_or_dash(gate.worst_case);
  if (gate.cases && *gate.cases > 0)
    html += small_html("of "_html + count_html(gate.cases) + (*gate.cases == 1 ? " case"_html : " cases"_html));
  return html;
}

Html result_html(const GateResult& gate) {
  if (!gate.has_passed()) return mark_html(false, "failed"_html);
  return mark_html(true, proves_that_gates_fail(gate) ? "fails as it must"_html : "passed"_html);
}

/// Chance, tolerance and noise of a gate that states them.
Html calibration_html(const GateResult& gate) {
  if (!gate.calibration) return {};
  const auto& [level, tolerance, noise] = *gate.calibration;
  const Html unit = unit_html(gate.unit);
  Html html;
  if (level)
    html += element(
        "small", *level > 0.0 ? "level: fails by chance in at most "_html + number_html(level, 2) + " of all runs"_html
                              : "level: 0, no chance"_html);
  html +=
      element("small", "tolerance: "_html + exact_html(tolerance.value) + unit + "; "_html + text(tolerance.reason));
  if (!noise.source.empty()) {
    const auto& sigma = noise.standard_deviation;
    html += element("small", "noise: "_html + (sigma ? "σ = "_html + exact_html(sigma) + unit + "; "_html : Html()) +
                                 text(noise.source));
  }
  return html;
}

Html description(const GateResult& gate) {
  Html html = element("span", {{"class", "title"}}, text_or_dash(gate.title)) + element("code", text_or_dash(gate.id));
  if (!gate.statistic.empty()) html += element("small", "statistic: "_html + text(gate.statistic));
  Html why;
  if (!gate.reason.empty()) why += element("small", text(gate.reason));
  why += calibration_html(gate);
  if (why.empty()) return html;
  if (gate.kind) why = element("small", text(entry_of(*gate.kind).sentence)) + why;
  return html + element("details", gate.has_passed() ? Attributes{} : Attributes{{"open", ""}},
                        inline_element("summary", "why this bound"_html) + why);
}

Html gate_table(std::vector<GateResult> gates) {
  std::stable_sort(gates.begin(), gates.end(),
                   [](const GateResult& a, const GateResult& b) { return reading_order(a) < reading_order(b); });
  HtmlTable table("Gates, failures first", "gates filterable",
                  {{"Gate"_html, false},
                   {"Result"_html, false},
                   {"Value ± uncertainty"_html},
                   {"Bound, with unit"_html},
                   {"Worst case"_html, false}});
  for (const GateResult& gate : gates)
    table.add_row({description(gate), result_html(gate), measured_html(gate.value, gate.uncertainty, 3),
                   bound_html(gate), worst_case_html(gate)},
                  gate.has_passed() ? RowState{"", "passed"} : RowState{"fail", "failed"});
  return table.html();
}

Html mutant_table(const std::vector<MutantFinding>& mutants) {
  HtmlTable table("Deliberately wrong inputs that the gates have to reject", "",
                  {{"Mutant"_html, false},
                   {"What was made wrong"_html, false},
                   {"Rejected"_html, false},
                   {"Value"_html},
                   {"Bound"_html}});
  for (const MutantFinding& mutant : mutants) {
    const bool rejected = mutant.failed_as_it_must.value_or(false);
    table.add_row(
        {code_html(mutant.id), text_or_dash(mutant.what), mark_html(rejected, rejected ? "yes"_html : "no"_html),
         number_html(mutant.value, 3), exact_html(mutant.bound)},
        rejected ? "" : "fail");
  }
  return element("h3", "The gates can fail"_html) +
         element("p",
                 "Each statistic below was computed again with one input made wrong on purpose. A gate that let it "
                 "pass would be worthless."_html) +
         table.html();
}

}  // namespace

Html gates_section(const Json& report) {
  const std::vector<GateResult> gates = read_gate_results(report);
  const std::vector<MutantFinding> mutants = read_must_fail(report);
  if (gates.empty() && mutants.empty()) return {};
  Html html = element("h2", "Gates"_html);
  if (!gates.empty()) html += gate_table(gates);
  if (!mutants.empty()) html += mutant_table(mutants);
  return element("section", {{"id", "gates"}}, html);
}

}  // namespace sturm
