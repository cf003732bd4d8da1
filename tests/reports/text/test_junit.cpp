#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/text/junit.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

GateResult gate(const std::string& id, bool passed) {
  return {.id = id,
          .title = "A < B & \"C\"",
          .kind = GateKind::AtMost,
          .passed = passed,
          .statistic = "max_z",
          .value = 7.25,
          .uncertainty = std::nullopt,
          .bound = 6.0,
          .unit = "σ",
          .cases = std::nullopt,
          .worst_case = "P|1 m",
          .reason = "because",
          .calibration = std::nullopt};
}

std::string xml_of(const std::vector<GateResult>& results, const std::string& suite,
                   std::optional<double> seconds = std::nullopt) {
  return junit_xml(results, suite, seconds);
}

TEST(Junit, WholeDocument) {
  EXPECT_EQ(xml_of({gate("good", true), gate("bad", false)}, "sturm", 1.5),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuites tests=\"2\" failures=\"1\" errors=\"0\" time=\"1.500\">\n"
            "  <testsuite name=\"sturm\" tests=\"2\" failures=\"1\" errors=\"0\" time=\"1.500\">\n"
            "   <testcase classname=\"sturm.upper_bound\" name=\"good\"/>\n"
            "   <testcase classname=\"sturm.upper_bound\" name=\"bad\">\n"
            "    <failure type=\"upper_bound\" message=\"A &lt; B &amp; &quot;C&quot;: max_z = 7.25 σ, bound 6 "
            "(upper_bound)\">"
            "worst case: P|1 m&#10;because</failure>\n"
            "   </testcase>\n"
            "  </testsuite>\n"
            "</testsuites>\n");
}

TEST(Junit, HostileNamesStayInsideTheirAttribute) {
  const std::string xml = xml_of({gate("\"/><script>alert('x')</script>\n]]>", true)}, "a&b");
  EXPECT_THAT(xml, HasSubstr("name=\"&quot;/&gt;&lt;script&gt;alert(&apos;x&apos;)&lt;/script&gt;&#10;]]&gt;\""));
  EXPECT_THAT(xml, HasSubstr("classname=\"a&amp;b.upper_bound\""));
  EXPECT_THAT(xml, Not(HasSubstr("<script>")));
}

TEST(Junit, ControlCharactersAreReplaced) {
  const std::string xml = xml_of({gate(std::string("a\x01"
                                                   "b\0c",
                                                   5),
                                       true)},
                                 "s");
  EXPECT_THAT(xml, HasSubstr("name=\"a\xEF\xBF\xBD"
                             "b\xEF\xBF\xBD"
                             "c\""));
}

TEST(Junit, MissingValueReadsNone) {
  GateResult failed = gate("x", false);
  failed.value.reset();
  EXPECT_THAT(xml_of({failed}, "s"), HasSubstr("max_z = none σ, bound 6"));
}

TEST(Junit, NoGatesIsAnEmptySuite) {
  EXPECT_THAT(xml_of({}, "s"), HasSubstr("tests=\"0\" failures=\"0\""));
}

}  // namespace
}  // namespace sturm
