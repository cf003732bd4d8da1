#include <algorithm>
#include <vector>

#include "io/json/stored.h"
#include "reports/markup/markup.h"
#include "reports/markup/numbers.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

bool failed(const Json& gate) {
  return !boolean_at(gate, "passed").value_or(false);
}

bool proves_that_gates_fail(const Json& gate) {
  return text_at(gate, "kind") == "must_fail";
}

/// 0 failures, 1 gates, 2 gates that show that gates can fail.
int reading_order(const Json& gate) {
  return failed(gate) ? 0 : proves_that_gates_fail(gate) ? 2 : 1;
}

std::string bound_html(const Json& gate) {
  const auto bound = number_at(gate, "bound");
  if (!bound) return "–";
  const std::string kind = text_at(gate, "kind");
  std::string html = "≤ ";
  if (kind == "must_fail") html = "&gt; ";
  if (kind == "baseline") html = "baseline ± ";
  if (kind == "must_differ" || kind == "differs" || kind == "lower_bound" || kind == "at_least") html = "≥ ";
  const std::string unit = text_at(gate, "unit");
  html += exact_html(bound);
  return unit.empty() ? html : html.append(" ").append(escaped(unit));
}

std::string worst_case_html(const Json& gate) {
  const auto cases = number_at(gate, "cases");
  return text_html(text_at(gate, "worst_case")) +
         (cases ? "<small>of " + count_html(cases) + (*cases == 1.0 ? " case" : " cases") + "</small>" : "");
}

std::string result_html(const Json& gate) {
  if (failed(gate)) return "<strong class=\"mark fail\">failed</strong>";
  return proves_that_gates_fail(gate) ? "<span class=\"mark pass\">fails as it must</span>"
                                      : "<span class=\"mark pass\">passed</span>";
}

/// Chance, tolerance and noise of a gate that states them.
std::string calibration_html(const Json& gate) {
  std::string html;
  const std::string unit = text_at(gate, "unit").empty() ? "" : " " + escaped(text_at(gate, "unit"));
  if (const auto level = number_at(gate, "level"))
    html += element("small", "",
                    *level > 0.0 ? "level: fails by chance in at most " + number_html(level, 2) + " of all runs"
                                 : "level: 0, no chance");
  if (const auto tolerance = number_at(gate, "tolerance/value"))
    html += element("small", "",
                    "tolerance: " + exact_html(tolerance) + unit + "; " + escaped(text_at(gate, "tolerance/reason")));
  if (const std::string source = text_at(gate, "noise/source"); !source.empty()) {
    const auto noise = number_at(gate, "noise/standard_deviation");
    html += element("small", "", "noise: " + (noise ? "σ = " + exact_html(noise) + unit + "; " : "") + escaped(source));
  }
  return html;
}

std::string description(const Json& gate) {
  std::string html = element("span", "class=\"title\"", text_html(text_at(gate, "title"))) +
                     element("code", "", text_html(text_at(gate, "id")));
  if (const std::string statistic = text_at(gate, "statistic"); !statistic.empty())
    html += element("small", "", "statistic: " + escaped(statistic));
  std::string why;
  if (const std::string reason = text_at(gate, "reason"); !reason.empty()) why += element("small", "", escaped(reason));
  why += calibration_html(gate);
  if (why.empty()) return html;
  return html + element("details", failed(gate) ? "open=\"\"" : "", "<summary>why this bound</summary>" + why);
}

std::string gate_table(const Json& gates) {
  std::vector<const Json*> order;
  for (const Json& gate : gates) order.push_back(&gate);
  std::stable_sort(order.begin(), order.end(), [](auto* a, auto* b) { return reading_order(*a) < reading_order(*b); });
  HtmlTable table(
      "Gates, failures first", "gates filterable",
      {{"Gate", false}, {"Result", false}, {"Value ± uncertainty"}, {"Bound, with unit"}, {"Worst case", false}});
  for (const Json* gate : order) {
    table.add_row({description(*gate), result_html(*gate),
                   measured_html(number_at(*gate, "value"), number_at(*gate, "uncertainty"), 3), bound_html(*gate),
                   worst_case_html(*gate)},
                  RowState{failed(*gate) ? "fail" : "", failed(*gate) ? "failed" : "passed"});
  }
  return table.html();
}

std::string mutant_table(const Json& mutants) {
  HtmlTable table("Deliberately wrong inputs that the gates have to reject", "",
                  {{"Mutant", false}, {"What was made wrong", false}, {"Rejected", false}, {"Value"}, {"Bound"}});
  for (const Json& mutant : mutants) {
    const bool rejected = boolean_at(mutant, "failed_as_it_must").value_or(false);
    table.add_row({"<code>" + text_html(text_at(mutant, "id")) + "</code>", text_html(text_at(mutant, "what")),
                   rejected ? "<span class=\"mark pass\">yes</span>" : "<strong class=\"mark fail\">no</strong>",
                   number_html(number_at(mutant, "value"), 3), exact_html(number_at(mutant, "bound"))},
                  rejected ? "" : "fail");
  }
  return element("h3", "", "The gates can fail") +
         element("p", "",
                 "Each statistic below was computed again with one input made wrong on purpose. A gate that let it "
                 "pass would be worthless.") +
         table.html();
}

}  // namespace

std::string gates_section(const Json& report) {
  const Json& gates = array_at(report, "gates");
  const Json& mutants = array_at(report, "must_fail");
  if (gates.empty() && mutants.empty()) return "";
  std::string html = element("h2", "", "Gates");
  if (!gates.empty()) html += gate_table(gates);
  if (!mutants.empty()) html += mutant_table(mutants);
  return element("section", "id=\"gates\"", html);
}

}  // namespace sturm
