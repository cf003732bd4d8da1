// Defaults that a type has for those who fill it in C++ are the ones that the schemas state for documents.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/json/schema.h"
#include "io/specs/experiment/figure_spec.h"
#include "io/specs/experiment/lens_study_spec.h"
#include "io/specs/eye_spec.h"
#include "lensmodel/single_vision.h"

namespace sturm {
namespace {

using ::testing::EndsWith;

Json rules(const char* schema, const char* pointer) {
  return schema_document(schema).at(Json::json_pointer(pointer));
}

TEST(Defaults, TheCentreOfRotationIsOneNumber) {
  const double millimetres = 1e3 * Eye{}.rotation_center_m;
  EXPECT_EQ(rules("eye", "/properties/rotation_center_mm")["default"], millimetres);
  EXPECT_EQ(rules("experiment", "/properties/lens_study/properties/rotation_center_mm")["default"], millimetres);
  EXPECT_EQ(rules("experiment", "/definitions/rotation_center")["default"], millimetres);
  EXPECT_EQ(LensStudySpec{}.rotation_center_m, Eye{}.rotation_center_m);
  EXPECT_EQ(LensMapsFigure{}.rotation_center_m, Eye{}.rotation_center_m);
  EXPECT_EQ(DefocusMapsFigure{}.rotation_center_m, Eye{}.rotation_center_m);
}

TEST(Defaults,
     ALensSaysInWordsWhatItIsIfLeftOut) {  // a default would be filled into lenses by maker, where it is refused
  const Spectacles lens;
  EXPECT_EQ(1e3 * lens.vertex_distance_m, 12.0);
  EXPECT_THAT(rules("spectacles", "/definitions/lens_vertex_distance")["description"].get<std::string>(),
              EndsWith("12 if left out"));
  EXPECT_EQ(1e3 * lens.diameter_m, 70.0);
  EXPECT_THAT(rules("spectacles", "/definitions/lens_diameter")["description"].get<std::string>(),
              EndsWith("70 if left out"));
  EXPECT_EQ(SingleVisionDesign{}.vertex_distance_m, lens.vertex_distance_m);
  EXPECT_EQ(SingleVisionDesign{}.diameter_m, lens.diameter_m);
}

TEST(Defaults, APrescriptionHasThoseOfTheSchema) {
  const Prescription rx = read_prescription(Json{{"sphere_D", -2.0}}, {"x.json", ""});
  EXPECT_EQ(rx.sphere_D, -2.0);
  EXPECT_EQ(rx.cylinder_D, 0.0);
  EXPECT_EQ(rx.prism_cm_per_m, 0.0);
  EXPECT_EQ(rx.vertex_distance_m, 12e-3);
}

}  // namespace
}  // namespace sturm
