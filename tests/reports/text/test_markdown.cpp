#include <gmock/gmock.h>

#include <array>
#include <nlohmann/json.hpp>

#include "reports/text/markdown.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

GateResult gate(const char* title, bool passed) {
  return {.id = "g",
          .title = title,
          .kind = GateKind::AtMost,
          .passed = passed,
          .statistic = "",
          .value = 2.5,
          .uncertainty = 0.25,
          .bound = 2.0,
          .unit = "σ",
          .cases = std::nullopt,
          .worst_case = "A|1 m|4 mm",
          .reason = "",
          .calibration = std::nullopt};
}

Verdict verdict(bool passed, const std::string& sentence) {
  return {.passed = passed, .sentence = sentence, .findings = {}};
}

TEST(ReportMarkdown, ShowsFailuresBeforeTheFold) {
  const std::string text = report_markdown({{"title", "Two eyes"}}, std::array{gate("Good", true), gate("Bad", false)},
                                           verdict(false, "1 of 2 gates passed."));
  EXPECT_THAT(text, HasSubstr("## ✗ Two eyes\n\n1 of 2 gates passed.\n"));
  EXPECT_THAT(text, HasSubstr("| ✗ | Bad | 2.5 ± 0.25 | ≤ 2 σ | A\\|1 m\\|4 mm |\n"));  // a bar would end the cell
  EXPECT_LT(text.find("| Bad |"), text.find("<details>"));
  EXPECT_GT(text.find("| Good |"), text.find("<details>"));
}

TEST(ReportMarkdown, HostileTextsStayText) {
  const std::string text = report_markdown({{"title", "<img src=x>\n# [a](b)"}}, {}, verdict(true, ""));
  EXPECT_THAT(text, Not(HasSubstr("<img")));
  EXPECT_THAT(text, Not(HasSubstr("\n# ")));
  EXPECT_THAT(text, HasSubstr("\\[a\\](b)"));
}

TEST(ReportMarkdown, WithoutNumbersSaysNone) {
  GateResult broken = gate("No value", false);
  broken.value = broken.uncertainty = std::nullopt;
  EXPECT_THAT(report_markdown(Json::object(), std::array{broken}, {}), HasSubstr("| No value | none | ≤ 2 σ |"));
}

}  // namespace
}  // namespace sturm
