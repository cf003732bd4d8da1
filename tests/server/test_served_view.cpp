#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/files/sandbox.h"
#include "io/images/image_formats.h"
#include "reports/markup/pictures.h"
#include "server/served_view.h"
#include "support/source_folder.h"

namespace sturm {
namespace {

const std::string folder = STURM_SOURCE_DIR "/configs/views/";

ServedView served(const std::string& spectacles = "null") {
  Json document = parse_json(R"({"format": "sturm.render/1", "scene": "../scenes/cornell_box.json",
    "camera": {"position_m": [0, 0, 2], "look_at_m": [0, 0, 0], "vfov_deg": 40, "resolution": [4, 3]},
    "eye": {"prescription": {"sphere_D": -2}, "pupil_diameter_mm": 4},
    "spectacles": )" + spectacles +
                                 R"(,
    "method": {"type": "path_trace", "ray_model": "power_matrix", "samples_per_pixel": 4}})",
                             "served");
  RenderSpec spec = read_render_spec(document, folder + "served.json");
  return {std::move(document), std::move(spec)};
}

/// The message of the InputError that the request causes.
std::string complaint(const std::string& body, const ServedView& view) {
  try {
    read_render_request(body, view);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

std::string request(const Json& view, const Json& picture = nullptr) {
  return Json{{"view", view}, {"picture", picture}}.dump();
}

class Requests : public ::testing::Test {
 protected:
  Requests() : view_(before_the_sandbox().first), worn_(before_the_sandbox().second), changed_(view_.document) {}

  /// Naked, and through spectacles.
  static const std::pair<ServedView, ServedView>& before_the_sandbox() {
    static const auto views = [] {
      std::pair<ServedView, ServedView> read{served(), served(R"("../lenses/oblique_astigmat.json")")};
      enter_sandbox();
      return read;
    }();
    return views;
  }

  ServedView view_, worn_;
  Json changed_;
};

TEST_F(Requests, TheEyeIsThePagesAndTheSceneIsTheServers) {
  changed_["eye"]["prescription"] = {{"sphere_D", 1.5}, {"cylinder_D", -0.5}, {"axis_deg", 20}};
  changed_["scene"] = "/etc/passwd";
  const RenderRequest read = read_render_request(request(changed_), view_);
  EXPECT_EQ(read.spec.eye.eye.pupil_radius_m, 2e-3);
  EXPECT_EQ((*read.spec.resolved)["eye"]["prescription"]["sphere_D"], 1.5);
  EXPECT_EQ(read.spec.scene.input_files, view_.spec.scene.input_files);
  EXPECT_FALSE(read.page_picture);
}

TEST_F(Requests, SpectaclesAreKeptWhereTheyAreTheServersOwn) {
  ASSERT_TRUE(worn_.spec.eye.spectacles);
  const RenderRequest read = read_render_request(request(worn_.document), worn_);
  ASSERT_TRUE(read.spec.eye.spectacles);
  EXPECT_EQ(read.spec.eye.spectacles->diameter_m, worn_.spec.eye.spectacles->diameter_m);
  EXPECT_EQ((*read.spec.resolved)["spectacles"], "../lenses/oblique_astigmat.json");
  worn_.document["spectacles"] = nullptr;
  EXPECT_FALSE(read_render_request(request(worn_.document), worn_).spec.eye.spectacles);
}

TEST_F(Requests, NoFileCanBeNamed) {
  for (const std::string file : {"../lenses/oblique_astigmat.json", "/etc/passwd"}) {
    changed_["spectacles"] = file;
    EXPECT_NE(complaint(request(changed_), view_).find("--sandbox"), std::string::npos) << file;
  }
  changed_["spectacles"] = "lens.json";  // in a folder that is not there
  EXPECT_NE(complaint(request(changed_), view_), "none");
  changed_["spectacles"] = nullptr;
  changed_["eye"] = folder + "../eyes/hofer_5.json";
  EXPECT_NE(complaint(request(changed_), view_).find("--sandbox"), std::string::npos);
}

TEST_F(Requests, ThePictureIsThePagesOwn) {
  Image picture(4, 3, 3);
  picture.at(3, 2)[1] = 1.0f;
  const RenderRequest read = read_render_request(request(changed_, data_uri(picture)), view_);
  ASSERT_TRUE(read.page_picture);
  EXPECT_EQ(read.page_picture->pixels, picture.pixels);
  for (const Json& wrong :
       {Json(1), Json("picture.png"), Json("data:image/png;base64,AAAA"), Json(data_uri(Image(3, 4, 3)))})
    EXPECT_NE(complaint(request(changed_, wrong), view_), "none") << wrong;
}

TEST_F(Requests, WhatIsTooLargeOrWrongIsNamed) {
  EXPECT_NE(complaint("[1", view_), "none");
  EXPECT_NE(complaint("{}", view_).find("/view"), std::string::npos);
  Json large = changed_;
  large["camera"]["resolution"] = {4000, 1001};
  EXPECT_NE(complaint(request(large), view_).find("/camera/resolution"), std::string::npos);
  large["camera"]["resolution"] = {4, 3};
  large["method"]["samples_per_pixel"] = 4097;
  EXPECT_NE(complaint(request(large), view_).find("/method/samples_per_pixel"), std::string::npos);
  changed_["eye"]["prescription"]["sphere_D"] = "minus two";
  EXPECT_NE(complaint(request(changed_), view_).find("/eye/prescription/sphere_D"), std::string::npos);
}

}  // namespace
}  // namespace sturm
