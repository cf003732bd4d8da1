#include "compare/findings/gate_power.h"

#include <algorithm>
#include <string>
#include <vector>

#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

/// Gates that noticed anything, as they are without an error, in the order in which they did.
std::vector<GateThatNoticed> gates_that_noticed(const std::vector<NoticedMutation>& mutations) {
  std::vector<GateThatNoticed> gates;
  for (const NoticedMutation& mutation : mutations)
    for (const GateThatNoticed& caught : mutation.caught_by)
      if (std::none_of(gates.begin(), gates.end(), [&](const GateThatNoticed& g) { return g.gate == caught.gate; }))
        gates.push_back(caught);
  return gates;
}

Html mutation_list(const std::vector<NoticedMutation>& mutations) {
  HtmlTable table("Errors put into one predictor at a time", "",
                  {{"Error"_html, false}, {"What is wrong"_html, false}, {"Gates that notice"_html}});
  for (const NoticedMutation& mutation : mutations) {
    const std::size_t gates = mutation.caught_by.size();
    const Html count = gates > 0 ? count_html(static_cast<double>(gates)) : mark_html(false, "none"_html);
    table.add_row({code_html(mutation.id), text_or_dash(mutation.what), count}, gates > 0 ? "" : "fail");
  }
  return table.html();
}

/// A name that may be broken behind its underscores: as many columns as errors have to fit into the page.
Html breakable_html(const std::string& name) {
  Html html;
  for (const char c : name) html += c == '_' ? "_<wbr/>"_html : text(std::string_view(&c, 1));
  return html;
}

/// Value of `gate` under a mutation, where it noticed.
Html cell_html(const NoticedMutation& mutation, const std::string& gate) {
  for (const GateThatNoticed& caught : mutation.caught_by)
    if (caught.gate == gate) return mark_html(true, caught.value ? number_html(caught.value, 3) : "no value"_html);
  return "·"_html;
}

Html matrix(const std::vector<NoticedMutation>& mutations) {
  const std::vector<GateThatNoticed> gates = gates_that_noticed(mutations);
  if (gates.empty()) return {};
  std::vector<Column> columns = {{"Gate"_html, false}, {"Bound"_html}, {"Nothing wrong"_html}};
  for (const NoticedMutation& mutation : mutations)
    columns.push_back({inline_element("code", breakable_html(mutation.id))});
  HtmlTable table("Values beyond the bound, by gate and error", "", columns);
  for (const GateThatNoticed& gate : gates) {
    std::vector<Cell> cells = {code_html(gate.gate), exact_html(gate.bound) + unit_html(gate.unit),
                               number_html(gate.honest_value, 3)};
    for (const NoticedMutation& mutation : mutations) cells.push_back(cell_html(mutation, gate.gate));
    table.add_row(cells);
  }
  return table.html();
}

Html false_alarms(const GatePower& power) {
  if (!power.false_alarms_per_run) return {};
  return element("p", "With nothing wrong, the levels of all "_html + count_html(power.gates) +
                          " gates add up to "_html + number_html(power.false_alarms_per_run, 2) +
                          " false alarms in a run."_html);
}

}  // namespace

Html gate_power_section(const Json& report) {
  const GatePower power = read_gate_power(report);
  if (power.mutations.empty()) return {};
  return element("section", {{"id", "gate_power"}},
                 element("h2", "What the gates can see"_html) +
                     element("p",
                             "Each error was put into the inputs or the data of one predictor; the other one, and what "
                             "was measured of it, "
                             "stayed. Then all gates were evaluated again. Listed are those that pass on this report "
                             "and fail with the error."_html) +
                     mutation_list(power.mutations) + matrix(power.mutations) + false_alarms(power));
}

}  // namespace sturm
