#include <algorithm>
#include <string>
#include <vector>

#include "io/json/stored.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

/// Gates that noticed anything, in the order in which they did.
std::vector<std::string> gates_that_noticed(const Json& mutations) {
  std::vector<std::string> gates;
  for (const Json& mutation : mutations)
    for (const Json& gate : array_at(mutation, "caught_by"))
      if (const std::string id = text_at(gate, "gate"); std::find(gates.begin(), gates.end(), id) == gates.end())
        gates.push_back(id);
  return gates;
}

Html mutation_list(const Json& mutations) {
  HtmlTable table("Errors put into one predictor at a time", "",
                  {{"Error"_html, false}, {"What is wrong"_html, false}, {"Gates that notice"_html}});
  for (const Json& mutation : mutations) {
    const std::size_t gates = array_at(mutation, "caught_by").size();
    const Html count = gates > 0 ? count_html(static_cast<double>(gates)) : mark_html(false, "none"_html);
    table.add_row({code_html(text_at(mutation, "id")), text_or_dash(text_at(mutation, "what")), count},
                  gates > 0 ? "" : "fail");
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
Html cell_html(const Json& mutation, const std::string& gate) {
  for (const Json& caught : array_at(mutation, "caught_by"))
    if (text_at(caught, "gate") == gate)
      return mark_html(true, number_at(caught, "value") ? number_html(number_at(caught, "value"), 3) : "no value"_html);
  return "·"_html;
}

Html matrix(const Json& mutations) {
  std::vector<Column> columns = {{"Gate"_html, false}, {"Bound"_html}, {"Nothing wrong"_html}};
  for (const Json& mutation : mutations)
    columns.push_back({inline_element("code", breakable_html(text_at(mutation, "id")))});
  HtmlTable table("Values beyond the bound, by gate and error", "", columns);
  for (const std::string& gate : gates_that_noticed(mutations)) {
    std::vector<Cell> cells;
    for (const Json& mutation : mutations)
      for (const Json& caught : array_at(mutation, "caught_by"))
        if (cells.empty() && text_at(caught, "gate") == gate) {
          cells = {Cell(code_html(gate)),
                   Cell(exact_html(number_at(caught, "bound")) + unit_html(text_at(caught, "unit"))),
                   Cell(number_html(number_at(caught, "honest_value"), 3))};
        }
    for (const Json& mutation : mutations) cells.push_back(Cell(cell_html(mutation, gate)));
    table.add_row(cells);
  }
  return table.html();
}

Html false_alarms(const Json& power) {
  const auto rate = number_at(power, "false_alarms_per_run");
  if (!rate) return {};
  return element("p", "With nothing wrong, the levels of all "_html + count_html(number_at(power, "gates")) +
                          " gates add up to "_html + number_html(rate, 2) + " false alarms in a run."_html);
}

}  // namespace

Html gate_power_section(const Json& report) {
  const Json& power = value_at(report, "gate_power");
  const Json& mutations = array_at(power, "mutations");
  if (mutations.empty()) return {};
  return element("section", {{"id", "gate_power"}},
                 element("h2", "What the gates can see"_html) +
                     element("p",
                             "Each error was put into the inputs or the data of one predictor; the other one, and what "
                             "was measured of it, "
                             "stayed. Then all gates were evaluated again. Listed are those that pass on this report "
                             "and fail with the error."_html) +
                     mutation_list(mutations) + matrix(mutations) + false_alarms(power));
}

}  // namespace sturm
