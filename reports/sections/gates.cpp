#include <algorithm>
#include <vector>

#include "io/json/stored.h"
#include "io/specs/experiment/gate_kind.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

bool failed(const Json& gate) {
  return !boolean_at(gate, "passed").value_or(false);
}

/// Null for a kind that is not known.
const GateKindEntry* kind_of(const Json& gate) {
  return gate_kind_in_report(text_at(gate, "kind"));
}

bool proves_that_gates_fail(const Json& gate) {
  const GateKindEntry* kind = kind_of(gate);
  return kind && kind->kind == GateKind::MustFail;
}

/// 0 failures, 1 gates, 2 gates that show that gates can fail.
int reading_order(const Json& gate) {
  return failed(gate) ? 0 : proves_that_gates_fail(gate) ? 2 : 1;
}

Html bound_html(const Json& gate) {
  const auto bound = number_at(gate, "bound");
  if (!bound) return absent_html();
  const GateKindEntry* kind = kind_of(gate);
  const Html sign = kind ? text(sign_of(kind->passing)) + " "_html : Html();
  return sign + exact_html(bound) + unit_html(text_at(gate, "unit"));
}

Html worst_case_html(const Json& gate) {
  const auto cases = number_at(gate, "cases");
  Html html = text_or_dash(text_at(gate, "worst_case"));
  if (cases) html += small_html("of "_html + count_html(cases) + (*cases == 1.0 ? " case"_html : " cases"_html));
  return html;
}

Html result_html(const Json& gate) {
  if (failed(gate)) return mark_html(false, "failed"_html);
  return mark_html(true, proves_that_gates_fail(gate) ? "fails as it must"_html : "passed"_html);
}

/// Chance, tolerance and noise of a gate that states them.
Html calibration_html(const Json& gate) {
  Html html;
  const Html unit = unit_html(text_at(gate, "unit"));
  if (const auto level = number_at(gate, "level"))
    html += element(
        "small", *level > 0.0 ? "level: fails by chance in at most "_html + number_html(level, 2) + " of all runs"_html
                              : "level: 0, no chance"_html);
  if (const auto tolerance = number_at(gate, "tolerance/value"))
    html += element("small", "tolerance: "_html + exact_html(tolerance) + unit + "; "_html +
                                 text(text_at(gate, "tolerance/reason")));
  if (const std::string source = text_at(gate, "noise/source"); !source.empty()) {
    const auto noise = number_at(gate, "noise/standard_deviation");
    html += element(
        "small", "noise: "_html + (noise ? "σ = "_html + exact_html(noise) + unit + "; "_html : Html()) + text(source));
  }
  return html;
}

Html description(const Json& gate) {
  Html html = element("span", {{"class", "title"}}, text_or_dash(text_at(gate, "title"))) +
              element("code", text_or_dash(text_at(gate, "id")));
  if (const std::string statistic = text_at(gate, "statistic"); !statistic.empty())
    html += element("small", "statistic: "_html + text(statistic));
  Html why;
  if (const std::string reason = text_at(gate, "reason"); !reason.empty()) why += element("small", text(reason));
  why += calibration_html(gate);
  if (why.empty()) return html;
  if (const GateKindEntry* kind = kind_of(gate)) why = element("small", text(kind->sentence)) + why;
  return html + element("details", failed(gate) ? Attributes{{"open", ""}} : Attributes{},
                        inline_element("summary", "why this bound"_html) + why);
}

Html gate_table(const Json& gates) {
  std::vector<const Json*> order;
  for (const Json& gate : gates) order.push_back(&gate);
  std::stable_sort(order.begin(), order.end(), [](auto* a, auto* b) { return reading_order(*a) < reading_order(*b); });
  HtmlTable table("Gates, failures first", "gates filterable",
                  {{"Gate"_html, false},
                   {"Result"_html, false},
                   {"Value ± uncertainty"_html},
                   {"Bound, with unit"_html},
                   {"Worst case"_html, false}});
  for (const Json* gate : order) {
    table.add_row({description(*gate), result_html(*gate),
                   measured_html(number_at(*gate, "value"), number_at(*gate, "uncertainty"), 3), bound_html(*gate),
                   worst_case_html(*gate)},
                  RowState{failed(*gate) ? "fail" : "", failed(*gate) ? "failed" : "passed"});
  }
  return table.html();
}

Html mutant_table(const Json& mutants) {
  HtmlTable table("Deliberately wrong inputs that the gates have to reject", "",
                  {{"Mutant"_html, false},
                   {"What was made wrong"_html, false},
                   {"Rejected"_html, false},
                   {"Value"_html},
                   {"Bound"_html}});
  for (const Json& mutant : mutants) {
    const bool rejected = boolean_at(mutant, "failed_as_it_must").value_or(false);
    table.add_row({code_html(text_at(mutant, "id")), text_or_dash(text_at(mutant, "what")),
                   mark_html(rejected, rejected ? "yes"_html : "no"_html), number_html(number_at(mutant, "value"), 3),
                   exact_html(number_at(mutant, "bound"))},
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
  const Json& gates = array_at(report, "gates");
  const Json& mutants = array_at(report, "must_fail");
  if (gates.empty() && mutants.empty()) return {};
  Html html = element("h2", "Gates"_html);
  if (!gates.empty()) html += gate_table(gates);
  if (!mutants.empty()) html += mutant_table(mutants);
  return element("section", {{"id", "gates"}}, html);
}

}  // namespace sturm
