#include "reports/text/markdown.h"

#include <nlohmann/json.hpp>

#include "compare/findings/stored_run.h"
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

std::string number(const Number& value) {
  return value ? plain_number(*value, 3) : "none";
}

std::string bound(const GateResult& gate) {
  return (gate.kind ? std::string(sign_of(entry_of(*gate.kind).passing)) + " " : "") + number(gate.bound) +
         (gate.unit.empty() ? "" : " " + cell(gate.unit));
}

std::string table(std::span<const GateResult> gates, bool of_passed) {
  std::string rows;
  for (const GateResult& gate : gates) {
    if (gate.has_passed() != of_passed) continue;
    rows += std::string("| ") + (of_passed ? "✓" : "✗") + " | " + cell(gate.title) + " | " + number(gate.value) +
            (gate.uncertainty ? " ± " + plain_number(*gate.uncertainty, 2) : "") + " | " + bound(gate) + " | " +
            cell(gate.worst_case) + " |\n";
  }
  return rows.empty() ? "" : "| | gate | value | bound | worst case |\n|---|---|---|---|---|\n" + rows;
}

}  // namespace

std::string gates_markdown(const std::string& title, std::span<const GateResult> results, const Verdict& verdict) {
  std::string text = "## " +
                     std::string(verdict.has_passed()   ? "✓ "
                                 : verdict.has_failed() ? "✗ "
                                                        : "") +
                     cell(title) + "\n\n" + cell(verdict.sentence) + "\n";
  if (const std::string failures = table(results, false); !failures.empty()) text += "\n" + failures;
  if (const std::string passes = table(results, true); !passes.empty())
    text += "\n<details><summary>Gates that passed</summary>\n\n" + passes + "\n</details>\n";
  return text;
}

std::string report_markdown(const Json& report, std::span<const GateResult> results, const Verdict& verdict) {
  std::string text = gates_markdown(text_at(report, "title"), results, verdict);
  const StoredRun run = read_stored_run(report);
  text += "\nSeed " + number(run.seed) + ", commit " + cell(run.commit) + ", " + number(run.total_seconds()) +
          " s with " + number(run.threads) + " threads. Values ± one standard error.\n";
  return text;
}

}  // namespace sturm
