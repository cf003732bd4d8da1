#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "ellipse_query_testing.h"
#include "support/units.h"

namespace sturm {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::mm;

Json worn_query() {
  return parse_json(R"({
    "format": "sturm.ellipse/1",
    "eye": {"prescription": {"sphere_D": -2.0, "cylinder_D": -1.5, "axis_deg": 30, "vertex_distance_mm": 12}, "pupil_diameter_mm": 4.0},
    "spectacles": {"vertex_distance_mm": 14, "center_thickness_mm": 2, "refractive_index": 1.5, "diameter_mm": 60,
                   "front": {"type": "sphere", "radius_mm": 250},
                   "back": {"type": "torus", "sweep_radius_mm": 125, "generator_radius_mm": 90, "sweep_meridian_deg": 30}},
    "targets": [{"distance_m": "inf"}],
    "methods": ["conoid"]
  })",
                    "q.json");
}

EllipseQuery worn_with(const std::vector<std::string>& assignments) {
  return query_with(worn_query(), assignments);
}
std::string worn_error_with(const std::vector<std::string>& assignments) {
  return query_error_with(worn_query(), assignments);
}

std::string worn_error_without(const std::string& parent, const std::string& key) {
  Json document = worn_query();
  document[Json::json_pointer(parent)].erase(key);
  return input_error([&] { read_ellipse_query(document, "q.json"); });
}

TEST(SpectaclesSpec, MountingInSi) {
  EXPECT_TRUE(worn_with({}).spectacles->mounting.straight());
  const Mounting m =
      worn_with({R"(/spectacles/mounting={"decentration_mm": [2, -3], "pantoscopic_tilt_deg": 8, "wrap_deg": -5})"})
          .spectacles->mounting;
  EXPECT_DOUBLE_EQ(m.decentration_m().x(), 2 * mm);
  EXPECT_DOUBLE_EQ(m.decentration_m().y(), -3 * mm);
  EXPECT_NEAR(m.pantoscopic_tilt(), 0.13962634015954636, 1e-16);
  EXPECT_NEAR(m.wrap(), -0.087266462599716474, 1e-16);
  EXPECT_THAT(worn_error_with({R"(/spectacles/mounting={"tilt_deg": 8})"}), HasSubstr("/spectacles/mounting"));
  EXPECT_THAT(worn_error_with({R"(/spectacles/mounting={"wrap_deg": 60})"}),
              AllOf(HasSubstr("/spectacles/mounting/wrap_deg"), HasSubstr("60")));
}

TEST(SpectaclesSpec, PrismOfThePrescription) {
  const std::string lens =
      R"({"single_vision": {"center_thickness_mm": 3, "refractive_index": 1.5, "base_curve_D": 5}})";
  EXPECT_FALSE(worn_with({"/spectacles=" + lens}).spectacles->mounting.has_wedge());
  const auto prism =
      worn_with({"/spectacles=" + lens, "/eye/prescription/prism_cm_per_m=2", "/eye/prescription/prism_base_deg=180"});
  // Base at the examiner's 180°, the wearer's right: the back surface falls away towards the eye there. Thin wedge:
  // slope 0.02/(n − 1).
  EXPECT_NEAR(prism.spectacles->mounting.wedge().x(), 0.04, 0.002);
  EXPECT_THAT(worn_error_with({"/eye/prescription/prism_cm_per_m=2"}), HasSubstr("prism_base_deg"));
}

TEST(SpectaclesSpec, TwoSurfacesInSi) {
  const Spectacles lens = worn_with({}).spectacles.value();
  EXPECT_DOUBLE_EQ(lens.vertex_distance_m, 14 * mm);
  EXPECT_DOUBLE_EQ(lens.center_thickness_m, 2 * mm);
  EXPECT_EQ(lens.refractive_index, 1.5);
  EXPECT_DOUBLE_EQ(lens.diameter_m, 60 * mm);
  EXPECT_NEAR(std::get<SphereSurface>(lens.front).curvature, 4.0, 1e-15);
  const auto& torus = std::get<TorusSurface>(lens.back);
  EXPECT_NEAR(torus.sweep_curvature(), 8.0, 1e-14);
  EXPECT_NEAR(torus.generator_curvature(), 11.111111111111111, 1e-14);
  EXPECT_NEAR(torus.sweep_direction().y() / torus.sweep_direction().x(), -0.57735026918962576,
              1e-15);  // the wearer's 150°
}

TEST(SpectaclesSpec, DefaultsNullAndConics) {
  Json document = worn_query();
  document["spectacles"].erase("vertex_distance_mm");
  document["spectacles"].erase("diameter_mm");
  document["spectacles"]["front"] = {{"type", "sphere"}, {"radius_mm", nullptr}};
  document["spectacles"]["back"] = {{"type", "conic"}, {"radius_mm", -80}, {"conic_constant", -1.5}};
  const Spectacles lens = read_ellipse_query(document, "q.json").spectacles.value();
  EXPECT_DOUBLE_EQ(lens.vertex_distance_m, 12 * mm);
  EXPECT_DOUBLE_EQ(lens.diameter_m, 70 * mm);
  EXPECT_EQ(std::get<SphereSurface>(lens.front).curvature, 0.0);
  EXPECT_DOUBLE_EQ(std::get<ConicSurface>(lens.back).curvature, -12.5);
  EXPECT_EQ(std::get<ConicSurface>(lens.back).conic_constant, -1.5);
  EXPECT_FALSE(worn_with({"/spectacles=null"}).spectacles);
}

TEST(SpectaclesSpec, WhatIsMissingIsNamed) {
  EXPECT_THAT(
      worn_error_without("/spectacles", "front"),
      HasSubstr("q.json: /spectacles: got no \"front\", expected \"front\" and \"back\", or \"single_vision\""));
  EXPECT_THAT(worn_error_without("/spectacles", "back"), HasSubstr("/spectacles: got no \"back\""));
  EXPECT_THAT(worn_error_without("/spectacles", "refractive_index"),
              HasSubstr("/spectacles: got no \"refractive_index\""));
  EXPECT_THAT(worn_error_without("/spectacles", "center_thickness_mm"),
              HasSubstr("/spectacles: got no \"center_thickness_mm\""));
  EXPECT_THAT(worn_error_without("/spectacles/front", "radius_mm"),
              HasSubstr("/spectacles/front: got no \"radius_mm\", expected \"radius_mm\" for a sphere"));
  EXPECT_THAT(worn_error_without("/spectacles/back", "sweep_meridian_deg"),
              HasSubstr("/spectacles/back: got no \"sweep_meridian_deg\""));
  EXPECT_THAT(worn_error_without("/spectacles/back", "generator_radius_mm"),
              HasSubstr("/spectacles/back: got no \"generator_radius_mm\""));
}

TEST(SpectaclesSpec, WhatDoesNotFitIsNamed) {
  EXPECT_THAT(worn_error_with({"/spectacles/front/radius_mm=0"}),
              HasSubstr("/spectacles/front/radius_mm: got 0, expected a radius of at least 1.0 mm"));
  EXPECT_THAT(worn_error_with({"/spectacles/front/sweep_radius_mm=90"}),
              HasSubstr("/spectacles/front/sweep_radius_mm: got 90, expected no \"sweep_radius_mm\" for a sphere"));
  EXPECT_THAT(worn_error_with({"/spectacles/front/conic_constant=1"}),
              HasSubstr("/spectacles/front/conic_constant: got 1"));
  EXPECT_THAT(worn_error_with({"/spectacles/back/radius_mm=90"}), HasSubstr("/spectacles/back/radius_mm: got 90"));
  EXPECT_THAT(worn_error_with({"/spectacles/front/type=aspere"}), HasSubstr("/spectacles/front/type: got \"aspere\""));
  EXPECT_THAT(worn_error_with({"/spectacles/refractive_index=0.9"}),
              HasSubstr("/spectacles/refractive_index: got 0.9"));
  EXPECT_THAT(worn_error_with({"/spectacles/center_thickness_mm=0"}),
              HasSubstr("/spectacles/center_thickness_mm: got 0"));
  EXPECT_THAT(worn_error_with({"/spectacles/centre_thickness_mm=2"}),
              HasSubstr("did you mean \"center_thickness_mm\"?"));
  EXPECT_THAT(worn_error_with({"/spectacles=nowhere.json"}),
              AllOf(HasSubstr("/spectacles: got \"nowhere.json\""), HasSubstr("there is no file")));
}

const std::string maker =
    R"(/spectacles={"single_vision": {"base_curve_D": 2, "center_thickness_mm": 2, "refractive_index": 1.5}})";

TEST(SpectaclesSpec, ASingleVisionLensForTheEye) {
  // The prescription is written for 12 mm, where the lens stands by default: the documented example, 124.833 and 90.821
  // mm.
  const auto torus = std::get<TorusSurface>(worn_with({maker}).spectacles->back);
  EXPECT_NEAR(1.0 / torus.sweep_curvature(), 124.833 * mm, 5e-7);
  EXPECT_NEAR(1.0 / torus.generator_curvature(), 90.821 * mm, 5e-7);
  // At 0 mm the eye needs F/(1 − dF): −2/1.024 and −3.5/1.042. Front 2 D carried to the back: 2/(1 − 2·0.002/1.5)
  // = 2.005348.
  const auto contact =
      std::get<TorusSurface>(worn_with({maker, "/spectacles/single_vision/vertex_distance_mm=0"}).spectacles->back);
  EXPECT_NEAR(0.5 * contact.sweep_curvature(), 2.0053475935828877 + 2.0 / 1.024, 1e-12);
  EXPECT_NEAR(0.5 * contact.generator_curvature(), 2.0053475935828877 + 3.5 / 1.042, 1e-12);
}

TEST(SpectaclesSpec, ASingleVisionLensAsStated) {
  const Spectacles lens =
      worn_with({maker, R"(/spectacles/single_vision/prescription={"sphere_D": -1})"}).spectacles.value();
  EXPECT_NEAR(0.5 * std::get<SphereSurface>(lens.back).curvature, 3.0053475935828877, 1e-13);
  EXPECT_NEAR(0.5 * std::get<SphereSurface>(lens.front).curvature, 2.0, 1e-15);
}

TEST(SpectaclesSpec, ErrorsOfTheMaker) {
  EXPECT_THAT(worn_error_with({maker, R"(/spectacles/single_vision/prescription={"sphere_D": -1, "cylinder_D": -1})"}),
              HasSubstr("/spectacles/single_vision/prescription: got no \"axis_deg\""));
  EXPECT_THAT(worn_error_with({maker, "/spectacles/diameter_mm=50"}),
              HasSubstr("/spectacles/diameter_mm: got 50, expected no \"diameter_mm\" beside \"single_vision\""));
  EXPECT_THAT(
      worn_error_with({maker, "/spectacles/single_vision/refractive_index=1"}),
      AllOf(HasSubstr("/spectacles/single_vision: got a refractive index"), HasSubstr("a lens that can be made")));
  EXPECT_THAT(worn_error_with({R"(/spectacles={"single_vision": {"refractive_index": 1.5}})"}),
              HasSubstr("/spectacles/single_vision: got no \"center_thickness_mm\""));
}

TEST(SpectaclesSpec, AFileOfItsOwn) {
  const TemporaryFolder folder;
  Json document = worn_query(), lens = document["spectacles"];
  lens["format"] = "sturm.spectacles/1";
  write_text(folder / "lenses/l.json", lens.dump());
  document["spectacles"] = "../lenses/l.json";
  const std::string file = (folder / "queries/q.json").string();
  const EllipseQuery q = read_ellipse_query(document, file);
  EXPECT_DOUBLE_EQ(q.spectacles->vertex_distance_m, 14 * mm);
  EXPECT_THAT(q.input_files, ElementsAre((folder / "lenses/l.json").string()));
  lens["front"].erase("radius_mm");
  write_text(folder / "lenses/l.json", lens.dump());
  EXPECT_THAT(input_error([&] { read_ellipse_query(document, file); }),
              HasSubstr("lenses/l.json: /front: got no \"radius_mm\""));
}

}  // namespace
}  // namespace sturm
