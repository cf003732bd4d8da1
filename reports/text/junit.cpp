#include "reports/text/junit.h"

#include <cstdio>

#include "io/files/formatted_text.h"
#include "reports/markup/escaped.h"

namespace sturm {

namespace {

std::string xml(const std::string& text) {
  return escaped(text, Dialect::Xml);
}

std::string number_text(const Number& value) {
  return value ? exact_number(*value) : "none";
}

std::string kind_of(const GateResult& gate) {
  return gate.kind ? std::string(entry_of(*gate.kind).report_word) : std::string();
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + xml(value) + "\"";
}

std::string failure_of(const GateResult& gate) {
  const std::string kind = kind_of(gate);
  const std::string message = gate.title + ": " + gate.statistic + " = " + number_text(gate.value) +
                              (gate.unit.empty() ? "" : " " + gate.unit) + ", bound " + number_text(gate.bound) + " (" +
                              kind + ")";
  return "    <failure" + attribute("type", kind) + attribute("message", message) + ">" +
         xml("worst case: " + gate.worst_case + "\n" + gate.reason) + "</failure>\n";
}

}  // namespace

std::string junit_xml(std::span<const GateResult> results, const std::string& suite, std::optional<double> seconds) {
  std::size_t failures = 0;
  std::string cases;
  for (const GateResult& gate : results) {
    cases += "   <testcase" + attribute("classname", suite + "." + kind_of(gate)) + attribute("name", gate.id);
    if (gate.has_passed()) {
      cases += "/>\n";
    } else {
      ++failures;
      cases += ">\n" + failure_of(gate) + "   </testcase>\n";
    }
  }
  std::string counts = attribute("tests", std::to_string(results.size())) +
                       attribute("failures", std::to_string(failures)) + attribute("errors", "0");
  if (seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", *seconds);
    counts += attribute("time", text);
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts + ">\n  <testsuite" +
         attribute("name", suite) + counts + ">\n" + cases + "  </testsuite>\n</testsuites>\n";
}

}  // namespace sturm
