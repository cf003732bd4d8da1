// Pictures of a report as structs and back.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/findings/picture_json.h"
#include "support/source_folder.h"

namespace sturm {
namespace {

Json stored_report() {
  std::ifstream file(STURM_SOURCE_DIR "/tests/reference/reports/pictures.json");
  return Json::parse(file);
}

TEST(PictureFindings, AStoredReportIsWrittenAgainByteForByte) {
  const Json report = stored_report();
  Json again = {{"images", Json::array()}, {"agreement", Json::array()}};
  const std::vector<PictureFinding> findings = picture_findings(report);
  ASSERT_EQ(findings.size(), 6u);
  for (const PictureFinding& finding : findings) {
    const Json json = to_json(finding);
    EXPECT_EQ(picture_finding(json, finding.measures, finding.replicates), finding) << finding.id;
    again[list_name(finding.measures)].push_back(json);
  }
  for (const char* list : {"images", "agreement"}) EXPECT_EQ(again[list].dump(1), report[list].dump(1)) << list;
}

TEST(PictureFindings, HoldWhatTheReportSays) {
  const std::vector<PictureFinding> findings = picture_findings(stored_report());
  const PictureFinding &box = findings[0], &same = findings[3], &naked = findings[4], &worn = findings[5];
  EXPECT_EQ(box.measures, PictureMeasures::Metrics);
  EXPECT_EQ(box.ray_model, RayModel::power_matrix);
  EXPECT_EQ(box.replicates, 4u);          // as the experiment has it
  EXPECT_EQ(box.samples_per_pixel, 64u);  // 4 × 16
  ASSERT_EQ(box.predictions.size(), 1u);
  EXPECT_TRUE(box.prediction().metric("ssim_display").degrees.has_value());
  EXPECT_FALSE(box.prediction().metric("rmse_linear").has_error);
  EXPECT_FALSE(box.prediction().metric("no such metric").value.has_value());
  EXPECT_EQ(box.noise_floor.uncertainties.size(), 3u);
  EXPECT_TRUE(same.noise_floor.uncertainties.empty());  // two replicates have none
  EXPECT_EQ(same.same_view_as, "plain/power_matrix");
  EXPECT_EQ(naked.measures, PictureMeasures::Regions);
  EXPECT_EQ(naked.samples_per_pixel, 64u);  // stated for each of four replicates
  EXPECT_EQ(naked.predictions.at(1).kind, PredictionKind::Layered);
  EXPECT_EQ(naked.predictions[1].whole().name, "whole");
  EXPECT_EQ(naked.predictions[1].whole().pixels, 1024u);
  EXPECT_EQ(worn.spectacles, true);
  EXPECT_EQ(worn.predictions.at(1).kind, PredictionKind::Multipass);
}

TEST(PictureFindings, WhatIsMissingOrOfAnotherTypeIsNone) {
  for (const Json& entry : {Json(nullptr), Json(3), Json::object(),
                            Json{{"metrics", "none"},
                                 {"noise_floor", 1},
                                 {"predictions", {1, nullptr}},
                                 {"samples_per_pixel", -3},
                                 {"ray_model", "by hand"},
                                 {"parts", "x"}}})
    for (const PictureMeasures measures : picture_measures) {
      const PictureFinding finding = picture_finding(entry, measures);
      EXPECT_FALSE(finding.samples_per_pixel.has_value());
      EXPECT_TRUE(finding.prediction().metrics.empty());
      EXPECT_FALSE(finding.prediction().whole().rmse.value.has_value());
      EXPECT_TRUE(finding.noise_floor.metrics.empty());
      EXPECT_NO_THROW(to_json(finding));
    }
}

TEST(PictureFindings, MutatedOnesAreWholeFindings) {
  const Json honest = stored_report();
  PictureFinding finding = picture_findings(honest)[0];
  PictureFinding moved = finding;
  moved.predictions[0].metrics["shift_x_px"].value = 0.5;
  finding.mutated["moved"] = moved;
  Json report = honest;
  report["images"][0] = to_json(finding);
  EXPECT_EQ(picture_findings(report)[0], finding);
  Json mutated = honest;
  mutated["images"][0] = report["images"][0]["mutated"]["moved"];
  EXPECT_EQ(picture_findings(mutated)[0], moved);
  report["images"][0].erase("mutated");
  EXPECT_EQ(report.dump(), honest.dump());
}

}  // namespace
}  // namespace sturm
