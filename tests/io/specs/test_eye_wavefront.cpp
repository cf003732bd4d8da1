// Eyes with a measured wavefront, views with spectacles, projections and gazes, as documents.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/json/schema.h"
#include "io/specs/eye_spec.h"
#include "io/specs/render_spec.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;

Json eye_document() {
  return Json::parse(
      R"({"wavefront": {"coefficients_um": {"4": 1.2990381056766578, "8": 0.2}, "pupil_diameter_mm": 6}, "pupil_diameter_mm": 4})");
}

Json view_document() {
  return Json::parse(R"({
    "format": "sturm.render/1",
    "scene": {"materials": {"grey": {"albedo": [0.5, 0.5, 0.5]}}, "spheres": [{"center_m": [0, 0, -2], "radius_m": 0.1, "material": "grey"}]},
    "camera": {"position_m": [0, 0, 0], "look_at_m": [0, 0, -1], "vfov_deg": 40, "resolution": [8, 8]},
    "eye": {"prescription": {"sphere_D": 0}, "pupil_diameter_mm": 4},
    "method": {"type": "path_trace", "ray_model": "power_matrix"}
  })");
}

template <class Read>
std::string error_of(Read&& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string eye_error(const Json& document) {
  return error_of([&] {
    validate(document, "eye", "eye.json");
    read_eye(document, {"eye.json", ""});
  });
}

std::string view_error(const Json& document) {
  return error_of([&] { read_render_spec(document, "view.json"); });
}

TEST(EyeWavefront, AListAndAnObjectAreTheSame) {
  Json list = eye_document();
  list["wavefront"]["coefficients_um"] = {0, 0, 0, 0, 1.2990381056766578, 0, 0, 0, 0.2};
  const Eye a = read_eye(eye_document(), {"eye.json", ""}), b = read_eye(list, {"eye.json", ""});
  EXPECT_EQ(a.wavefront->coefficients(), b.wavefront->coefficients());
  EXPECT_NEAR(a.correction.spherical_equivalent(), -1.0, 1e-12);  // −4√3 c/a² over 6 mm
  EXPECT_NEAR(a.pupil_radius_m, 2e-3, 1e-18);
  EXPECT_NEAR(a.wavefront->radius_m(), 3e-3, 1e-18);
}

TEST(EyeWavefront, TheTwoSecondOrdersDifferBySphericalAberration) {
  Json document = eye_document();
  document["wavefront"]["coefficients_um"] = {{"12", 0.2}};
  document["pupil_diameter_mm"] = 6;
  EXPECT_NEAR(read_eye(document, {"eye.json", ""}).correction.xx(), 0.0, 1e-12);
  document["wavefront"]["second_order"] = "paraxial";
  EXPECT_NEAR(read_eye(document, {"eye.json", ""}).correction.xx(), 0.59628479, 1e-8);  // 12√5·0.2e-6/9e-6
}

TEST(EyeWavefront, RefusesWhatItCannotMean) {
  Json larger = eye_document();
  larger["pupil_diameter_mm"] = 6.5;
  EXPECT_THAT(eye_error(larger), HasSubstr("/wavefront/pupil_diameter_mm: got 6"));
  Json both = eye_document();
  both["prescription"] = {{"sphere_D", -1}};
  EXPECT_THAT(eye_error(both), HasSubstr("combine"));
  both["wavefront"]["combine"] = true;
  EXPECT_EQ(eye_error(both), "");
  Json alone = eye_document();
  alone["wavefront"]["combine"] = true;
  EXPECT_THAT(eye_error(alone), HasSubstr("a prescription for \"combine\""));
  Json neither = eye_document();
  neither.erase("wavefront");
  EXPECT_THAT(eye_error(neither), HasSubstr("\"wavefront\""));
  for (const char* index : {"231", "999", "04", "-1", "x", ""}) {
    Json wrong = eye_document();
    wrong["wavefront"]["coefficients_um"] = {{index, 0.1}};
    EXPECT_NE(eye_error(wrong), "") << index;
  }
}

TEST(EyeWavefront, OtherOrdersAndTheOtherEye) {
  const auto coefficients = [](const Json& changes) {
    Json document = eye_document();
    document["wavefront"].merge_patch(changes);
    validate(document, "eye", "eye.json");
    return read_eye(document, {"eye.json", ""}).wavefront->coefficients();
  };
  const Json none = {{"coefficients_um", {{"4", nullptr}, {"8", nullptr}}}};
  const auto only = [&](const char* number, Json changes) {
    changes["coefficients_um"] = none["coefficients_um"];
    changes["coefficients_um"][number] = 0.2;
    return coefficients(changes);
  };
  // Wearer's frame: the cosine coma Z₈ changes its sign, spherical aberration Z₁₂ does not.
  EXPECT_NEAR(only("8", {{"order", "noll"}}).at(8), -0.2e-6, 1e-21);
  EXPECT_NEAR(only("7", {{"order", "fringe"}, {"normalised", true}}).at(8), -0.2e-6, 1e-21);
  EXPECT_NEAR(only("9", {{"order", "fringe"}}).at(12), 0.2e-6 / 2.23606797749979, 1e-21);
  EXPECT_NEAR(only("12", {{"normalised", false}}).at(12), 0.2e-6 / 2.23606797749979, 1e-21);
  EXPECT_NEAR(only("8", {{"eye", "left"}, {"mirror_to", "right"}}).at(8), 0.2e-6, 1e-21);
  EXPECT_NEAR(only("8", {{"eye", "left"}, {"mirror_to", "left"}}).at(8), -0.2e-6, 1e-21);
  Json sideless = eye_document();
  sideless["wavefront"]["mirror_to"] = "left";
  EXPECT_THAT(eye_error(sideless), HasSubstr("\"mirror_to\" without \"eye\""));
  Json piston = eye_document();
  piston["wavefront"].merge_patch({{"order", "noll"}, {"coefficients_um", {{"0", 0.1}}}});
  EXPECT_THAT(eye_error(piston),
              HasSubstr("/wavefront/coefficients_um/0: got 0.1, expected a number of order \"noll\""));
}

TEST(RenderView, KnowsGazesProjectionsAndPairs) {
  Json document = view_document();
  document["camera"]["gaze"] = "foveal";
  document["eye"]["accommodation"] = {{"mode", "best"}, {"amplitude_D", 3}};
  EXPECT_EQ(read_render_spec(document, "view.json").camera.gaze, Gaze::Foveal);
  document["camera"]["gaze"] = "camera";
  EXPECT_THAT(view_error(document), HasSubstr("in camera gaze one accommodation"));
  document = view_document();
  document["camera"].erase("vfov_deg");
  EXPECT_THAT(view_error(document), HasSubstr("no \"vfov_deg\""));
  document["camera"]["projection"] = "equirectangular";
  EXPECT_EQ(read_render_spec(document, "view.json").camera.projection, Projection::Equirectangular);
  document["camera"]["gaze"] = "foveal";
  EXPECT_THAT(view_error(document), HasSubstr("/camera/gaze"));
  document = view_document();
  document["left"] = {{"eye", {{"prescription", {{"sphere_D", -2}}}, {"pupil_diameter_mm", 5}}}};
  EXPECT_THAT(view_error(document), HasSubstr("stereo"));
  document["camera"]["stereo"] = {{"interpupillary_distance_mm", 63}};
  const RenderSpec pair = read_render_spec(document, "view.json");
  EXPECT_NEAR(*pair.camera.interpupillary_distance_m, 0.063, 1e-15);
  EXPECT_EQ(pair.left->eye.prescription.sphere_D, -2.0);
  EXPECT_EQ(pair.eye.eye.prescription.sphere_D, 0.0);
  EXPECT_EQ(*read_render_spec(*pair.resolved, "view.json").resolved, *pair.resolved);
}

TEST(RenderView, APredictionIsOfTheNakedEyeLookingAhead) {
  Json document = view_document();
  document["method"] = {{"type", "predict"}};
  EXPECT_EQ(view_error(document), "");
  for (const auto& [pointer, value] :
       {std::pair("/camera/gaze", Json("foveal")), std::pair("/method/sampling", Json("rings")),
        std::pair("/spectacles",
                  Json::parse(R"({"single_vision": {"center_thickness_mm": 2, "refractive_index": 1.5}})")),
        std::pair("/eye/stiles_crawford_per_mm2", Json(0.05))}) {
    Json wrong = document;
    wrong[Json::json_pointer(pointer)] = value;
    EXPECT_NE(view_error(wrong), "") << pointer;
  }
}

TEST(RenderView, RingsNeedTheirSampling) {
  Json document = view_document();
  document["method"]["rings"] = {{"count", 4}};
  EXPECT_THAT(view_error(document), HasSubstr("/method/rings"));
  document["method"]["sampling"] = "rings";
  EXPECT_EQ(read_render_spec(document, "view.json").sampling.rings, 4);
}

TEST(WavefrontEye, AWrongIndexIsNamed) {
  for (const auto& [key, hint] : {std::pair("Z4", "did you mean \"4\"?"),
                                  {"c12", "did you mean \"12\"?"},
                                  {"04", "did you mean \"4\"?"},
                                  {"-1", "did you mean \"1\"?"},
                                  {"defocus", "defocus"}}) {
    Json document = eye_document();
    document["wavefront"]["coefficients_um"] = {{key, 1.0}};
    const std::string message = error_of([&] { validate(document, "eye", "eye.json"); });
    EXPECT_THAT(message, HasSubstr(std::string("eye.json: /wavefront/coefficients_um/") + key + ": got the key"))
        << message;
    EXPECT_THAT(message, HasSubstr("OSA/ANSI single index j"));
    EXPECT_THAT(message, HasSubstr(hint));
  }
}

}  // namespace
}  // namespace sturm
