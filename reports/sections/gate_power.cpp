#include <algorithm>
#include <string>
#include <vector>

#include "io/json/stored.h"
#include "reports/markup/markup.h"
#include "reports/markup/numbers.h"
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

std::string mutation_list(const Json& mutations) {
  HtmlTable table("Errors put into one predictor at a time", "",
                  {{"Error", false}, {"What is wrong", false}, {"Gates that notice"}});
  for (const Json& mutation : mutations) {
    const std::size_t gates = array_at(mutation, "caught_by").size();
    const std::string count =
        gates > 0 ? count_html(static_cast<double>(gates)) : "<strong class=\"mark fail\">none</strong>";
    table.add_row(
        {"<code>" + text_html(text_at(mutation, "id")) + "</code>", text_html(text_at(mutation, "what")), count},
        gates > 0 ? "" : "fail");
  }
  return table.html();
}

/// A name that may be broken behind its underscores: as many columns as errors have to fit into the page.
std::string breakable_html(const std::string& name) {
  std::string html;
  for (const char c : name) html += c == '_' ? std::string("_<wbr>") : escaped(std::string(1, c));
  return html;
}

/// Value of `gate` under a mutation, where it noticed.
std::string cell_html(const Json& mutation, const std::string& gate) {
  for (const Json& caught : array_at(mutation, "caught_by"))
    if (text_at(caught, "gate") == gate)
      return "<span class=\"mark pass\">" +
             (number_at(caught, "value") ? number_html(number_at(caught, "value"), 3) : "no value") + "</span>";
  return "·";
}

std::string matrix(const Json& mutations) {
  std::vector<Column> columns = {{"Gate", false}, {"Bound"}, {"Nothing wrong"}};
  for (const Json& mutation : mutations)
    columns.push_back({"<code>" + breakable_html(text_at(mutation, "id")) + "</code>"});
  HtmlTable table("Values beyond the bound, by gate and error", "", columns);
  for (const std::string& gate : gates_that_noticed(mutations)) {
    std::vector<Cell> cells;
    for (const Json& mutation : mutations)
      for (const Json& caught : array_at(mutation, "caught_by"))
        if (cells.empty() && text_at(caught, "gate") == gate) {
          const std::string unit = text_at(caught, "unit").empty() ? "" : " " + escaped(text_at(caught, "unit"));
          cells = {Cell("<code>" + text_html(gate) + "</code>"), Cell(exact_html(number_at(caught, "bound")) + unit),
                   Cell(number_html(number_at(caught, "honest_value"), 3))};
        }
    for (const Json& mutation : mutations) cells.push_back(Cell(cell_html(mutation, gate)));
    table.add_row(cells);
  }
  return table.html();
}

std::string false_alarms(const Json& power) {
  const auto rate = number_at(power, "false_alarms_per_run");
  if (!rate) return "";
  return element("p", "",
                 "With nothing wrong, the levels of all " + count_html(number_at(power, "gates")) +
                     " gates add up to " + number_html(rate, 2) + " false alarms in a run.");
}

}  // namespace

std::string gate_power_section(const Json& report) {
  const Json& power = value_at(report, "gate_power");
  const Json& mutations = array_at(power, "mutations");
  if (mutations.empty()) return "";
  return element("section", "id=\"gate_power\"",
                 element("h2", "", "What the gates can see") +
                     element("p", "",
                             "Each error was put into the inputs or the data of one predictor; the other one, and what "
                             "was measured of it, "
                             "stayed. Then all gates were evaluated again. Listed are those that pass on this report "
                             "and fail with the error.") +
                     mutation_list(mutations) + matrix(mutations) + false_alarms(power));
}

}  // namespace sturm
