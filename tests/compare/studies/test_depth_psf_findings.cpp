#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compare/findings/depth_psf_study.h"
#include "compare/studies/depth_psf/depth_psf_findings.h"

namespace sturm {
namespace {

DepthPsfFindings by_hand() {
  return {.map = {{"white", 4.0, 0.0, 0.05, 1.0, 1.1}, {"white", 4.0, 1.0, 0.07, 3.0, 3.1}, {"white", 2.0, 0.0, 0.24}},
          .eyes = {{.id = "nine",
                    .title = "Nine",
                    .pupil_mm = 6.0,
                    .eyes = 9,
                    .defocus_D = {0.2, 0.26, 0.3},
                    .share_above_step = 0.5}},
          .banding = {{1.0, "linear", 4, 17, 0.001, 0.002}}};
}

Number statistic(const Measurements& all, const std::string& name) {
  for (const Measurement& m : all)
    if (m.statistic == name) return m.value;
  return std::nullopt;
}

TEST(DepthPsfFindings, ComeBackAsTheyWere) {
  const DepthPsfFindings found = by_hand();
  EXPECT_EQ(depth_psf_findings({{"depth_psf_study", to_json(found)}}), found);
  EXPECT_FALSE(depth_psf_findings(Json::object()));
}

TEST(DepthPsfFindings, GatesSeeTheWorst) {
  Measurements all;
  measure_depth_psf_study({{"depth_psf_study", to_json(by_hand())}}, all);
  EXPECT_EQ(statistic(all, "depth_psf_study/map/white/4"), 0.07);
  EXPECT_EQ(statistic(all, "depth_psf_study/map/white/2"), 0.24);
  EXPECT_EQ(statistic(all, "depth_psf_study/eyes/nine/median_D"), 0.26);
  EXPECT_EQ(statistic(all, "depth_psf_study/eyes/nine/share_above_step"), 0.5);
  EXPECT_EQ(statistic(all, "depth_psf_study/banding/linear/4/1/rmse"), 0.001);
  EXPECT_EQ(statistic(all, "depth_psf_study/banding/linear/4/1/step"), 0.002);
}

TEST(DepthPsfFindings, AMissingNumberLeavesThePupilWithout) {
  DepthPsfFindings found = by_hand();
  found.map[1].total_variation.reset();
  Measurements all;
  measure_depth_psf_study({{"depth_psf_study", to_json(found)}}, all);
  EXPECT_FALSE(statistic(all, "depth_psf_study/map/white/4"));
}

TEST(DepthPsfFindings, QuartilesLieBetweenTheOrderedValues) {
  // Number k of n at k/(n + 1): of five values the quartiles are at 1.5, 3 and 4.5.
  EXPECT_THAT(quartiles_of({5.0, 1.0, 2.0, 4.0, 10.0}), ::testing::ElementsAre(1.5, 4.0, 7.5));
  EXPECT_FALSE(quartiles_of({1.0})[1]);
}

}  // namespace
}  // namespace sturm
