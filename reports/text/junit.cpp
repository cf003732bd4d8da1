#include "reports/text/junit.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "io/json/stored.h"
#include "reports/markup/escaped.h"

namespace sturm {

namespace {

std::string xml(const std::string& text) {
  return escaped(text, Dialect::Xml);
}

std::string number_text(const Json& gate, const char* name) {
  const auto value = number_at(gate, name);
  if (!value) return "none";
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", *value);
  return text;
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + xml(value) + "\"";
}

std::string failure_of(const Json& gate) {
  const std::string unit = text_at(gate, "unit");
  const std::string message = text_at(gate, "title") + ": " + text_at(gate, "statistic") + " = " +
                              number_text(gate, "value") + (unit.empty() ? "" : " " + unit) + ", bound " +
                              number_text(gate, "bound") + " (" + text_at(gate, "kind") + ")";
  return "    <failure" + attribute("type", text_at(gate, "kind")) + attribute("message", message) + ">" +
         xml("worst case: " + text_at(gate, "worst_case") + "\n" + text_at(gate, "reason")) + "</failure>\n";
}

}  // namespace

std::string junit_xml(const Json& gate_results, const std::string& suite, std::optional<double> seconds) {
  std::size_t failures = 0;
  std::string cases;
  for (const Json& gate : gate_results) {
    cases += "   <testcase" + attribute("classname", suite + "." + text_at(gate, "kind")) +
             attribute("name", text_at(gate, "id"));
    if (boolean_at(gate, "passed").value_or(false)) {
      cases += "/>\n";
    } else {
      ++failures;
      cases += ">\n" + failure_of(gate) + "   </testcase>\n";
    }
  }
  std::string counts = attribute("tests", std::to_string(gate_results.size())) +
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
