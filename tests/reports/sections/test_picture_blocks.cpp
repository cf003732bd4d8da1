#include <gmock/gmock.h>

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "compare/metrics/stored_images.h"
#include "io/images/exr.h"
#include "reports/sections/picture_blocks.h"
#include "reports/viewer/viewer.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;

constexpr PredictionKind kinds[] = {PredictionKind::Ellipses, PredictionKind::Layered, PredictionKind::Multipass};

/// Files of one view with a prediction of each kind, the further from path tracing the later; its finding.
PictureFinding finding_with_files(const std::filesystem::path& folder, int width, int height) {
  const auto write = [&](const std::string& name, double phase) {
    write_exr(folder / name, LayeredImage{{{"", testing::textured_image(width, height, phase)}}, {}});
  };
  PictureFinding finding;
  finding.measures = PictureMeasures::Regions;
  finding.id = "room";
  finding.path_traced.exr = "traced.exr";
  write("traced.exr", 0.0);
  double phase = 0.0;
  for (const PredictionKind kind : kinds) {
    PredictionFinding prediction;
    prediction.kind = kind;
    prediction.files.exr = name_of(kind) + ".exr";
    write(prediction.files.exr, phase += 0.2);
    finding.predictions.push_back(prediction);
  }
  return finding;
}

/// An empty folder of the test's own, removed with it.
class PictureBlocksOnPage : public ::testing::Test {
 protected:
  PictureBlocksOnPage()
      : folder_(std::filesystem::temp_directory_path() /
                ("sturm_blocks_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    std::filesystem::create_directories(folder_);
  }
  ~PictureBlocksOnPage() override { std::filesystem::remove_all(folder_); }

  const std::filesystem::path folder_;
};

Json case_in(const ViewerPayload& payload, std::size_t number = 0) {
  const std::string html = payload.html().markup();
  const std::size_t first = html.find('>') + 1;
  return Json::parse(html.substr(first, html.rfind("</script>") - first)).at("cases").at(number);
}

TEST_F(PictureBlocksOnPage, EachPredictionHasItsOwnMapsOnCommonScales) {
  ViewerPayload payload;
  const auto places = picture_blocks({finding_with_files(folder_, 24, 16)}, folder_, payload).blocks;
  ASSERT_EQ(places.size(), 1u);
  EXPECT_THAT(places[0].html.markup(), HasSubstr("class=\"viewer\" data-case=\"0\""));
  EXPECT_THAT(places[0].html.markup(), HasSubstr("stills"));
  const Json shown = case_in(payload);
  ASSERT_EQ(shown["pictures"].size(), 4u);
  EXPECT_EQ(shown["pictures"][0]["key"], "path_traced");
  ASSERT_EQ(shown["maps"].size(), 3 * (1 + viewer_maps().size()));
  std::size_t i = 0;
  for (const PredictionKind kind : kinds) {
    EXPECT_EQ(shown["pictures"][1 + i / (1 + viewer_maps().size())]["key"], name_of(kind));
    for (std::size_t m = 0; m <= viewer_maps().size(); ++m, ++i) {
      const Json &map = shown["maps"][i], &first = shown["maps"][m];
      EXPECT_EQ(map["of"], name_of(kind));
      EXPECT_EQ(map["key"], m == 0 ? "difference" : viewer_maps()[m - 1]);
      EXPECT_EQ(map["end"], first["end"]) << map["key"];
      if (kind != kinds[0]) {
        EXPECT_NE(map["halves"], first["halves"]) << map["key"];
      }
    }
  }
}

TEST_F(PictureBlocksOnPage, AllFindingsHaveOneScaleOfErrors) {
  PictureFinding regions = finding_with_files(folder_, 24, 16), metrics = regions;
  regions.predictions = {regions.predictions[2]};  // the furthest
  metrics.measures = PictureMeasures::Metrics;
  metrics.predictions = {metrics.predictions[0]};  // the nearest
  ViewerPayload alone, payload;
  const PictureBlocks near = picture_blocks({metrics}, folder_, alone);
  const PictureBlocks both = picture_blocks({metrics, regions}, folder_, payload);
  EXPECT_GT(both.error_limit, near.error_limit);
  const Json nearest = case_in(payload, 0), furthest = case_in(payload, 1);
  EXPECT_EQ(nearest["pictures"][1]["key"], "predicted");
  EXPECT_EQ(furthest["pictures"][1]["key"], "multipass");
  EXPECT_EQ(nearest["maps"][0]["end"], both.error_limit);
  EXPECT_EQ(furthest["maps"][0]["end"], both.error_limit);
  EXPECT_FALSE(nearest["maps"][0].contains("of"));  // there is nothing to tell it from
  EXPECT_THAT(both.blocks[0].html.markup(), HasSubstr("sturm compare ellipses.exr traced.exr"));
}

TEST_F(PictureBlocksOnPage, ANumberThatIsNoneHasAColour) {
  PictureFinding finding = finding_with_files(folder_, 24, 16);
  Image defect = testing::textured_image(24, 16, 0.2);
  *defect.at(3, 4) = std::numeric_limits<float>::quiet_NaN();
  write_exr(folder_ / "layered.exr", LayeredImage{{{"", defect}}, {}});
  ViewerPayload payload;
  const auto places = picture_blocks({finding}, folder_, payload).blocks;
  EXPECT_THAT(places.at(0).html.markup(), HasSubstr("stills"));
}

TEST_F(PictureBlocksOnPage, FilesThatDoNotFitAreANote) {
  const PictureFinding finding = finding_with_files(folder_, 24, 16);
  PictureFinding gone = finding;
  write_exr(folder_ / "layered.exr", LayeredImage{{{"", testing::textured_image(16, 16, 0.0)}}, {}});
  gone.path_traced.exr = "gone.exr";
  ViewerPayload payload;
  const auto places = picture_blocks({finding, gone}, folder_, payload).blocks;
  EXPECT_THAT(places.at(0).html.markup(), HasSubstr("No pictures: they differ in size"));
  EXPECT_THAT(places.at(1).html.markup(), HasSubstr("gone.exr"));
  EXPECT_TRUE(payload.html().empty());
}

TEST_F(PictureBlocksOnPage, SlowLeavesOutMapsBeforeItShrinks) {
  const PictureFinding finding = finding_with_files(folder_, 480, 480);
  // All maps: 480² × (3 + 3 × (3 + 7)) numbers of 2 bytes in base64 are 20.3 MB; with one map less 18.4 MB, which
  // fit 18.5.
  ViewerPayload payload;
  const auto places = picture_blocks({finding}, folder_, payload).blocks;
  const Json shown = case_in(payload);
  EXPECT_EQ(shown["factor"], 1);
  ASSERT_EQ(shown["maps"].size(), 3 * viewer_maps().size());
  for (const Json& map : shown["maps"]) EXPECT_NE(map["key"], viewer_maps().back());
  EXPECT_THAT(places[0].html.markup(), HasSubstr("These and more maps"));
  EXPECT_LT(payload.html().markup().size() + places[0].html.markup().size(), 25'000'000u);
  // Two of them: 3 maps of each prediction are 25.8 MB, and with half of the side 6.5 MB.
  ViewerPayload larger;
  picture_blocks({finding, finding}, folder_, larger);
  EXPECT_EQ(case_in(larger)["factor"], 2);
  EXPECT_EQ(case_in(larger)["maps"].size(), 9u);
  EXPECT_LT(larger.html().markup().size(), 7'000'000u);
}

}  // namespace
}  // namespace sturm
