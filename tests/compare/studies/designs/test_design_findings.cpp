#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compare/findings/design_study.h"
#include "compare/studies/designs/design_findings.h"

namespace sturm {
namespace {

DesignWearer wearer(const std::string& design, double distance_m, Number share, const std::string& status = "ok") {
  DesignWearer row;
  row.wearer = "P-OD";
  row.design = design;
  row.distance_m = StoredDistance{distance_m};
  row.share_blurred = share;
  row.median_D = share;
  row.status = status;
  return row;
}

DesignFindings ten_wearers() {
  DesignFindings found;
  found.conditions.clear_D = 0.25;
  found.designs = {{.id = "one", .largest_cylinder_D = 3.5}};
  for (int i = 1; i <= 10; ++i) found.wearers.push_back(wearer("one", 0.4, 0.1 * i));
  found.wearers.push_back(wearer("one", 0.4, std::nullopt, "the progressive surface ends before the rim"));
  found.wearers.push_back(wearer("one", std::numeric_limits<double>::infinity(), 0.3));
  return found;
}

TEST(DesignFindings, ASummaryForEachDesignAndDistance) {
  const std::vector<DesignSummary> summaries = design_summaries(ten_wearers());
  ASSERT_EQ(summaries.size(), 2u);
  EXPECT_EQ(summaries[0].wearers, 11u);
  EXPECT_EQ(summaries[0].not_made, 1u);
  EXPECT_NEAR(summaries[0].median_share.value(), 0.55, 1e-12);       // between 0.5 and 0.6
  EXPECT_NEAR(summaries[0].ninth_decile_share.value(), 0.9, 1e-12);  // nine of ten have at most 0.9
  EXPECT_NEAR(summaries[1].median_share.value(), 0.3, 1e-12);
  EXPECT_TRUE(summaries[1].distance_m->is_infinite());
}

TEST(DesignFindings, NobodyHasNoMedian) {
  DesignFindings found;
  found.wearers = {wearer("one", 1.0, std::nullopt, "too thick")};
  EXPECT_FALSE(design_summaries(found).at(0).median_share);
}

TEST(DesignFindings, ComeBackAsTheyWere) {
  const DesignFindings found = ten_wearers();
  const Json report = {{"design_study", to_json(found)}};
  EXPECT_EQ(design_findings(report).value(), found);
  EXPECT_EQ(report["design_study"]["wearers"][11]["distance_m"], "inf");
  EXPECT_FALSE(design_findings(Json::object()));
}

TEST(DesignFindings, GatesSeeTheWorstOfThem) {
  Measurements numbers;
  measure_design_study({{"design_study", to_json(ten_wearers())}}, numbers);
  ASSERT_EQ(numbers.size(), 3u);
  EXPECT_EQ(numbers[0].value, 3.5);
  EXPECT_EQ(numbers[1].subject, "one|0.4 m");
  EXPECT_EQ(numbers[2].subject, "one|inf m");
}

}  // namespace
}  // namespace sturm
