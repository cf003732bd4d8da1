#include "reports/text/markdown.h"

#include <nlohmann/json.hpp>

#include "io/files/formatted_text.h"
#include "io/json/stored.h"
#include "io/specs/experiment/gate_kind.h"

namespace sturm {

namespace {

/// Plain text inside a table's cell: nothing in it is markup, neither Markdown's nor HTML's.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '\n' || c == '\r')
      out += ' ';
    else if (std::string_view("\\`*_[]|~").find(c) != std::string_view::npos)
      out.append("\\").append(1, c);
    else
      out += c;
  }
  return out.empty() ? "–" : out;
}

std::string number(const Json& gate, const char* key) {
  const auto value = number_at(gate, key);
  return value ? plain_number(*value, 3) : "none";
}

std::string bound(const Json& gate) {
  const std::string unit = text_at(gate, "unit");
  const GateKindEntry* kind = gate_kind_in_report(text_at(gate, "kind"));
  return (kind ? std::string(sign_of(kind->passing)) + " " : "") + number(gate, "bound") +
         (unit.empty() ? "" : " " + cell(unit));
}

bool passed(const Json& gate) {
  return boolean_at(gate, "passed").value_or(false);
}

std::string table(const Json& gates, bool of_passed) {
  std::string rows;
  for (const Json& gate : gates) {
    if (passed(gate) != of_passed) continue;
    const auto uncertainty = number_at(gate, "uncertainty");
    rows += std::string("| ") + (of_passed ? "✓" : "✗") + " | " + cell(text_at(gate, "title")) + " | " +
            number(gate, "value") + (uncertainty ? " ± " + plain_number(*uncertainty, 2) : "") + " | " + bound(gate) +
            " | " + cell(text_at(gate, "worst_case")) + " |\n";
  }
  return rows.empty() ? "" : "| | gate | value | bound | worst case |\n|---|---|---|---|---|\n" + rows;
}

}  // namespace

std::string report_markdown(const Json& report, const Json& gate_results, const Json& verdict) {
  const bool all = boolean_at(verdict, "passed").value_or(false);
  std::string text = "## " + std::string(all ? "✓ " : "✗ ") + cell(text_at(report, "title")) + "\n\n" +
                     cell(text_at(verdict, "sentence")) + "\n";
  if (const std::string failures = table(gate_results, false); !failures.empty()) text += "\n" + failures;
  if (const std::string passes = table(gate_results, true); !passes.empty())
    text += "\n<details><summary>Gates that passed</summary>\n\n" + passes + "\n</details>\n";
  text += "\nSeed " + number(value_at(report, "provenance"), "seed") + ", commit " +
          cell(text_at(report, "provenance/commit")) + ", " + number(value_at(report, "provenance/seconds"), "total") +
          " s with " + number(value_at(report, "provenance"), "threads") + " threads. Values ± one standard error.\n";
  return text;
}

}  // namespace sturm
