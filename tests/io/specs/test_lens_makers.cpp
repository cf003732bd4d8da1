#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/io_testing.h"
#include "io/json/json_pointer_set.h"
#include "io/json/schema.h"
#include "io/specs/spectacles_spec.h"
#include "support/units.h"

namespace sturm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::mm;

Json progressive() {
  return parse_json(R"({"format": "sturm.spectacles/1",
                        "progressive": {"prescription": {"sphere_D": -1}, "addition_D": 2, "center_thickness_mm": 2.2,
                                        "refractive_index": 1.5, "diameter_mm": 40, "knot_spacing_mm": 0.5}})",
                    "lens.json");
}

SpectaclesSpec lens_with(const std::vector<std::string>& assignments, Json document = progressive()) {
  for (const std::string& assignment : assignments) apply_set(document, assignment);
  validate(document, "spectacles", "lens.json");
  return read_spectacles(document, {"lens.json", ""}, Eye::with({-2.0, 0.0, 180.0, 12 * mm}, 4 * mm));
}

std::string lens_error_with(const std::vector<std::string>& assignments) {
  return input_error([&] { lens_with(assignments); });
}

double height(const SpectaclesSpec& spec, double x_mm, double y_mm) {
  return sag(spec.lens->front, x_mm * mm, y_mm * mm)->value;
}

TEST(LensMakers, AProgressiveLens) {
  const SpectaclesSpec spec = lens_with({});
  ASSERT_EQ(spec.fits.size(), 1u);
  EXPECT_EQ(spec.fits[0].side, "front");
  EXPECT_NEAR(spec.fits[0].knot_spacing.x(), 0.5 * mm, 0.01 * mm);
  EXPECT_FALSE(spec.fits[0].height);
  EXPECT_GT(spec.fits[0].power->mean_D, 1e-5);
  EXPECT_FALSE(spec.material);
  EXPECT_EQ(spec.made_for->sphere_D, -1.0);
  // Vogel: −1/2 + 6 = 5.5 D, so 1/R = 11 /m in the far zone: at 10 mm 1/11 − √(1/11² − 0.01²).
  EXPECT_NEAR(height(spec, 0, 10), 0.55167389e-3, 1e-9);
  EXPECT_GT(height(spec, 0, -18), height(spec, 0, 18));  // more power below
}

TEST(LensMakers, DefaultsOfAProgressiveLens) {
  const SpectaclesSpec spec = lens_with({}),
                       stated = lens_with({"/progressive/corridor_start_mm=0", "/progressive/corridor_length_mm=18",
                                           "/progressive/inset_mm=2.5", R"(/progressive/eye="right")",
                                           "/progressive/zone_width_mm=10", "/progressive/base_curve_D=5.5",
                                           "/progressive/vertex_distance_mm=12"});
  for (const double x : {-9.0, 0.0, 7.0})
    for (const double y : {-15.0, -6.0, 8.0}) EXPECT_EQ(height(spec, x, y), height(stated, x, y));
  for (const char* other :
       {"/progressive/corridor_start_mm=3", "/progressive/corridor_length_mm=15", "/progressive/inset_mm=1",
        R"(/progressive/eye="left")", "/progressive/zone_width_mm=null", "/progressive/addition_D=1"})
    EXPECT_GT(std::abs(height(lens_with({other}), 7, -12) - height(spec, 7, -12)), 1e-7) << other;
}

TEST(LensMakers, ALeftLensIsTheMirroredRightOne) {
  const SpectaclesSpec right = lens_with({}), left = lens_with({R"(/progressive/eye="left")"});
  EXPECT_NEAR(height(right, -9, -13), height(left, 9, -13), 1e-17);
  EXPECT_GT(height(right, -9, -13),
            height(right, 9, -13));  // the nose of a right eye is on the wearer's left: there is the addition
}

TEST(LensMakers, AnEyeStandsInForThePrescription) {
  Json document = progressive();
  document["progressive"].erase("prescription");
  EXPECT_EQ(lens_with({}, document).made_for->sphere_D, -2.0);
}

TEST(LensMakers, AMaterialStandsInForTheIndex) {
  Json document = progressive();
  document["progressive"].erase("refractive_index");
  EXPECT_THAT(input_error([&] { lens_with({}, document); }),
              AllOf(HasSubstr("/progressive: got no \"refractive_index\""), HasSubstr("\"material\"")));
  const SpectaclesSpec spec = lens_with({R"(/progressive/material="MR-7")"}, document);
  EXPECT_EQ(spec.lens->refractive_index, 1.67);
  EXPECT_EQ(spec.material->abbe_number, 32.0);
  EXPECT_THAT(
      lens_error_with({R"(/progressive/material="MR-7")"}),
      HasSubstr("/progressive/refractive_index: got 1.5, expected no \"refractive_index\" beside \"material\""));
}

TEST(LensMakers, TheSchemaListsTheMaterials) {
  const Json names = schema_document("spectacles")["definitions"]["lens_material"]["enum"];
  EXPECT_EQ(names.size(), lens_materials().size());
  for (const Json& name : names) EXPECT_TRUE(lens_material(name.get<std::string>())) << name;
}

TEST(LensMakers, ErrorsOfAProgressiveLens) {
  EXPECT_THAT(lens_error_with({"/progressive/corridor_length_mm=0"}),
              HasSubstr("/progressive/corridor_length_mm: got 0"));
  EXPECT_THAT(lens_error_with({"/progressive/inset_mm=9.5"}),
              AllOf(HasSubstr("/progressive/inset_mm: got 9.5"), HasSubstr("less than half")));
  EXPECT_THAT(lens_error_with({"/progressive/knot_spacing_mm=0.01"}),
              AllOf(HasSubstr("/progressive/knot_spacing_mm: got 0.01"), HasSubstr("1/2000")));
  EXPECT_THAT(lens_error_with({"/progressive/base_curve_D=26"}),
              AllOf(HasSubstr("/progressive: got the progressive surface ends before the rim")));
  EXPECT_THAT(lens_error_with({"/diameter_mm=50"}), HasSubstr("expected no \"diameter_mm\" beside \"progressive\""));
  EXPECT_THAT(lens_error_with({R"(/single_vision={"center_thickness_mm": 2})"}),
              HasSubstr("no \"single_vision\" beside \"progressive\""));
}

TEST(LensMakers, ASagGridBesideTheLensFile) {
  const TemporaryFolder folder;
  std::string table = "x_mm,y_mm,z_mm\n";
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j)
      table += std::to_string(5 * i) + "," + std::to_string(5 * j) + "," +
               std::to_string(0.05 * i * i * i + 0.125 * j * j) + "\n";
  write_text(folder / "lenses/grids/front.csv", table);
  write_text(folder / "lenses/l.json",
             R"({"format": "sturm.spectacles/1", "center_thickness_mm": 3, "material": "CR-39", "diameter_mm": 36,
    "front": {"type": "sag_grid", "file": "grids/front.csv"}, "back": {"type": "sphere", "radius_mm": 100}})");
  const SpectaclesSpec spec = read_spectacles("lenses/l.json", {(folder / "eye.json").string(), ""}, Eye{});
  EXPECT_THAT(spec.input_files, ::testing::ElementsAre((folder / "lenses/l.json").string(),
                                                       (folder / "lenses/grids/front.csv").string()));
  EXPECT_NEAR(height(spec, 7.5, -2.5), (0.05 * 1.5 * 1.5 * 1.5 + 0.125 * 0.25) * mm,
              1e-17);  // cubics come back exactly
  EXPECT_LT(spec.fits.at(0).height->max, 1e-17);
  EXPECT_EQ(spec.material->name, "CR-39");
  write_text(folder / "lenses/l.json",
             R"({"format": "sturm.spectacles/1", "center_thickness_mm": 3, "refractive_index": 1.5,
    "front": {"type": "sag_grid"}, "back": {"type": "sphere", "radius_mm": 100, "file": "x.csv"}})");
  EXPECT_THAT(input_error([&] {
                read_spectacles("lenses/l.json", {(folder / "eye.json").string(), ""}, Eye{});
              }),
              HasSubstr("/front: got no \"file\""));
}

}  // namespace
}  // namespace sturm
