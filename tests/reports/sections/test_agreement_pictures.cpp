#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "compare/metrics/stored_images.h"
#include "io/images/exr.h"
#include "reports/sections/agreement_pictures.h"
#include "reports/viewer/viewer.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;

constexpr const char* kinds[] = {"ellipses", "layered", "multipass"};

/// Files of one view with a prediction of each kind, the further from path tracing the later; its entry in a report.
Json entry_with_files(const std::filesystem::path& folder, int width, int height) {
  const auto write = [&](const std::string& name, double phase) {
    write_exr(folder / name, LayeredImage{{{"", testing::textured_image(width, height, phase)}}, {}});
  };
  Json entry = {{"id", "room"}, {"files", {{"path_traced", "traced.exr"}}}, {"predictions", Json::array()}};
  write("traced.exr", 0.0);
  double phase = 0.0;
  for (const char* kind : kinds) {
    const std::string file = std::string(kind) + ".exr";
    write(file, phase += 0.2);
    entry["predictions"].push_back({{"kind", kind}, {"files", {{"predicted", file}}}});
  }
  return entry;
}

/// An empty folder of the test's own, removed with it.
class AgreementPictures : public ::testing::Test {
 protected:
  AgreementPictures()
      : folder_(std::filesystem::temp_directory_path() /
                ("sturm_agreement_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    std::filesystem::create_directories(folder_);
  }
  ~AgreementPictures() override { std::filesystem::remove_all(folder_); }

  const std::filesystem::path folder_;
};

Json case_in(const ViewerPayload& payload) {
  const std::string html = payload.html().markup();
  const std::size_t first = html.find('>') + 1;
  return Json::parse(html.substr(first, html.rfind("</script>") - first)).at("cases").at(0);
}

TEST_F(AgreementPictures, EachPredictionHasItsOwnMapsOnCommonScales) {
  ViewerPayload payload;
  const auto places = agreement_pictures(Json::array({entry_with_files(folder_, 24, 16)}), folder_, payload);
  ASSERT_EQ(places.size(), 1u);
  EXPECT_THAT(places[0].markup(), HasSubstr("class=\"viewer\" data-case=\"0\""));
  EXPECT_THAT(places[0].markup(), HasSubstr("stills"));
  const Json shown = case_in(payload);
  ASSERT_EQ(shown["pictures"].size(), 4u);
  EXPECT_EQ(shown["pictures"][0]["key"], "path_traced");
  ASSERT_EQ(shown["maps"].size(), 3 * (1 + viewer_maps().size()));
  std::size_t i = 0;
  for (const char* kind : kinds) {
    EXPECT_EQ(shown["pictures"][1 + i / (1 + viewer_maps().size())]["key"], kind);
    for (std::size_t m = 0; m <= viewer_maps().size(); ++m, ++i) {
      const Json &map = shown["maps"][i], &first = shown["maps"][m];
      EXPECT_EQ(map["of"], kind);
      EXPECT_EQ(map["key"], m == 0 ? "difference" : viewer_maps()[m - 1]);
      EXPECT_EQ(map["end"], first["end"]) << map["key"];
      if (kind != kinds[0]) {
        EXPECT_NE(map["halves"], first["halves"]) << map["key"];
      }
    }
  }
}

TEST_F(AgreementPictures, FilesThatDoNotFitAreANote) {
  Json entry = entry_with_files(folder_, 24, 16), gone = entry;
  write_exr(folder_ / "layered.exr", LayeredImage{{{"", testing::textured_image(16, 16, 0.0)}}, {}});
  gone["files"]["path_traced"] = "gone.exr";
  ViewerPayload payload;
  const auto places = agreement_pictures(Json::array({entry, gone}), folder_, payload);
  EXPECT_THAT(places.at(0).markup(), HasSubstr("No pictures: they differ in size"));
  EXPECT_THAT(places.at(1).markup(), HasSubstr("gone.exr"));
  EXPECT_TRUE(payload.html().empty());
}

TEST_F(AgreementPictures, SlowLeavesOutMapsBeforeItShrinks) {
  const Json entry = entry_with_files(folder_, 480, 480);
  // All maps: 480² × (3 + 3 × (3 + 7)) numbers of 2 bytes in base64 are 20.3 MB; with one map less 18.4 MB, which
  // fit 18.5.
  ViewerPayload payload;
  const auto places = agreement_pictures(Json::array({entry}), folder_, payload);
  const Json shown = case_in(payload);
  EXPECT_EQ(shown["factor"], 1);
  ASSERT_EQ(shown["maps"].size(), 3 * viewer_maps().size());
  for (const Json& map : shown["maps"]) EXPECT_NE(map["key"], viewer_maps().back());
  EXPECT_THAT(places[0].markup(), HasSubstr("These and more maps"));
  EXPECT_LT(payload.html().markup().size() + places[0].markup().size(), 25'000'000u);
  // Two of them: 3 maps of each prediction are 25.8 MB, and with half of the side 6.5 MB.
  ViewerPayload larger;
  agreement_pictures(Json::array({entry, entry}), folder_, larger);
  EXPECT_EQ(case_in(larger)["factor"], 2);
  EXPECT_EQ(case_in(larger)["maps"].size(), 9u);
  EXPECT_LT(larger.html().markup().size(), 7'000'000u);
}

}  // namespace
}  // namespace sturm
