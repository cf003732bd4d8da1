#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

#include "io/io_testing.h"
#include "io/json/schema.h"
#include "io/specs/eye_spec.h"
#include "io/specs/notation_tokens.h"
#include "io/specs/prescription_notation.h"

namespace sturm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const Source here{"x.json", "/rx"};

/// What a text for one eye is read as, in the plainest form.
std::string read(const std::string& text) {
  const auto eyes = parse_prescription_notation(text);
  EXPECT_EQ(eyes.size(), 1u) << text;
  return in_notation(eyes.at(0));
}

std::string refused(const std::string& text) {
  try {
    parse_prescription_notation(text);
  } catch (const NotationError& error) {
    return error.what();
  }
  ADD_FAILURE() << text << " was read";
  return "";
}

TEST(PrescriptionNotation, OnePrescriptionInEveryonesHand) {
  for (const char* text : {"-2.00 -1.50 x 30",
                           "-2.00 -1.50 X 030",
                           "-2.00/-1.50x30",
                           "-2.00-1.50x30",
                           "-2.00 / -1.50 × 30°",
                           "-2,00 -1,50 x 30",
                           "−2.00 −1.50 × 30",
                           "–2.00 –1.50 x 30",
                           "- 2.00 - 1.50 x 30",
                           "-2.00 -1.50 axis 30°",
                           "-2.00 -1.50 ax. 30 deg",
                           "-2.00 DS -1.50 DC x 30",
                           "-2.00DS/-1.50DCx30",
                           "-2.00 D -1.50 D ax 30",
                           "sph -2.00 cyl -1.50 ax 30",
                           "Sphere: -2.00 D; Cylinder: -1.50 D; Axis: 30 degrees",
                           "S -2.00 C -1.50 A 30",
                           "S-2.00 C-1.50 A30",
                           "sph -2,00 zyl -1,50 Achse 30°",
                           "-2.00 sph -1.50 cyl x 30",
                           "-2.00 (-1.50 x 30)",
                           "-2.00 -1.50 30",
                           "-2.00, -1.50, 30",
                           "-2.00,-1.50,30",
                           "-2.00/-1.50/30",
                           "Rx: -2 -1.5 x 30",
                           "-2.00\u00A0-1.50\u202Fx\u00A030",
                           "-2.00 -1½ * 30",
                           "-2.00 @ 30 / -3.50 @ 120",
                           "ax 30 sph -2.00 cyl -1.50",
                           "\t-2.00\n-1.50 x 30 "})
    EXPECT_EQ(read(text), "-2.00 -1.50 x 30") << text;
}

TEST(PrescriptionNotation, Spheres) {
  for (const char* text :
       {"+1.25 DS", "+1.25", "1.25 sph", "+1.25 D.S.", "sph +1.25", "+1.25 D", "+1,25 dpt", "+1.25 DS 0.00"})
    EXPECT_EQ(read(text), "+1.25 DS") << text;
  for (const char* text : {"plano", "PL", "Plano DS", "0.00", "-0.00", "pl."})
    EXPECT_EQ(read(text), "+0.00 DS") << text;
  for (const char* text :
       {"PL -0.75 x 180", "Plano/-0.75x180", "-0.75 DC x 180", "cyl -0.75 x 180", "sph PL cyl -0.75 ax 180"})
    EXPECT_EQ(read(text), "+0.00 -0.75 x 180") << text;
  EXPECT_EQ(read("-2.00 DS x 30"), "-2.00 DS x 30");  // an axis without a cylinder means nothing, and harms nothing
  EXPECT_EQ(read("-2.00 0.00 x 30"), "-2.00 DS x 30");
}

TEST(PrescriptionNotation, EyesAdditionsAndVertexDistances) {
  for (const char* text : {"OD -1.00/-0.50x90 add 2.00", "R: -1.00 -0.50 x 90 +2.00 add",
                           "RE -1.00 -0.50 x 90 ADD +2.00 D", "Right eye: -1.00 -0.50 x 90, Add. 2,00"})
    EXPECT_EQ(read(text), "OD -1.00 -0.50 x 90 ADD +2.00") << text;
  for (const char* text :
       {"-1.00 DS VD 12", "-1.00 DS BVD 12mm", "-1.00 DS, vertex distance: 12 mm", "-1.00 DS @ 12 mm"})
    EXPECT_EQ(read(text), "-1.00 DS VD 12") << text;
  for (const char* text : {"OS -1.00 DS", "L -1.00 DS", "O.S. -1.00 DS", "left -1.00 DS", "LE: -1.00"})
    EXPECT_EQ(read(text), "OS -1.00 DS") << text;
  const auto both = parse_prescription_notation("OD -1.00 DS OS PL -0.75 x 180");
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(in_notation(both[0]) + "|" + in_notation(both[1]), "OD -1.00 DS|OS +0.00 -0.75 x 180");
  EXPECT_EQ(parse_prescription_notation("OU +1.00 DS").size(), 2u);
}

TEST(PrescriptionNotation, Prisms) {
  for (const char* text : {"OD -1.00 DS 2^ base in", "OD -1.00 DS 2Δ BI", "OD -1.00 DS 2 pd b.i.",
                           "OD -1.00 DS prism 2 BI", "OD -1.00 DS 2 base in", "OD -1.00 DS 2∆ in"})
    EXPECT_EQ(read(text), "OD -1.00 DS 2^ BI") << text;
  EXPECT_EQ(read("-1.00 DS 1.5 prism base up"), "-1.00 DS 1.5^ BU");
  EXPECT_EQ(read("-1.00 -0.50 x 90 2^ BO 1^ BD"), "-1.00 -0.50 x 90 2^ BO 1^ BD");
  EXPECT_EQ(read("-1.00 DS 2^ base 180°"), "-1.00 DS 2^ base 180");
  EXPECT_EQ(read("2^ base in"), "+0.00 DS 2^ BI");
}

TEST(PrescriptionNotation, TheBaseMayStandBeforeItsAmount) {
  for (const char* text : {"OD +1.00 BI 2", "OD +1.00 2 BI", "OD +1.00 DS base in 2^", "OD +1.00 2 cm/m BI",
                           "OD +1.00 Pr. 2 nasal", "R +1,00 dpt Prisma 2 Basis innen", "OD +1.00 prism 2 B in"})
    EXPECT_EQ(read(text), "OD +1.00 DS 2^ BI") << text;
  for (const char* text : {"OS -1.00 -0.50 x 20 BU 1.5 BO 2", "OS -1.00 -0.50 x 20 1.5^ BU 2^ BO",
                           "OS -1.00 -0.50 x 20 2 temporal 1,5 oben"})
    EXPECT_EQ(read(text), "OS -1.00 -0.50 x 20 2^ BO 1.5^ BU") << text;
  EXPECT_EQ(read("OD PL 2 cm/m B 180"), "OD +0.00 DS 2^ base 180");
  EXPECT_THAT(refused("OD 1.00 BI 2"), HasSubstr("a sign before the sphere"));  // 1 D and 2^, or 1^ and 2 D
  EXPECT_THAT(refused("OD 1.00 prism 2 BI"), HasSubstr("a sign before the sphere"));
  EXPECT_THAT(refused("OD -1.00 DS BI 2 BU"), HasSubstr("an amount of prism"));
  EXPECT_THAT(refused("OD -1.00 DS base 2"), HasSubstr("2^ base 135"));
}

TEST(PrescriptionNotation, Fractions) {
  EXPECT_EQ(read("-2½ -1¼ x 30"), "-2.50 -1.25 x 30");
  EXPECT_EQ(read("-2 ½ -1 ¼ x 30"), "-2.50 -1.25 x 30");
  EXPECT_EQ(read("-½"), "-0.50 DS");
  // It had been a cylinder of one dioptre with axis 4.
  for (const char* text : {"-2 1/4", "-2 1/2 -1 3/4 x 30", "1/4", "-2/-1/4"})
    EXPECT_THAT(refused(text), HasSubstr("may be a fraction")) << text;
  EXPECT_EQ(read("-2/-1/40"), "-2.00 -1.00 x 40");
  EXPECT_EQ(read("-2.00/-1.00/4"), "-2.00 -1.00 x 4");
}

TEST(PrescriptionNotation, OtherCountriesWays) {
  EXPECT_EQ(read("OD : -1,75 (-0,50 à 90°)"), "OD -1.75 -0.50 x 90");
  EXPECT_EQ(read("-2·00 -1·50 x 30"), "-2.00 -1.50 x 30");
  EXPECT_EQ(read("-2.00 DS ⌢ -1.50 DC ╳ 30"), "-2.00 -1.50 x 30");
  EXPECT_EQ(read("-2.00 -1.50 \u0445 30"), "-2.00 -1.50 x 30");
  EXPECT_THAT(refused("90° (-0,50) -1,75"), HasSubstr("the axis, 90°, behind the cylinder"));
  EXPECT_THAT(refused("-2.00 -1.50 x 30 PD 63"), HasSubstr("without the distance of the pupils, \"PD 63\""));
  EXPECT_THAT(refused("-2.00 -1.50 x 30 PD 31.5"), HasSubstr("without the distance of the pupils"));
  EXPECT_EQ(read("OD -2.00 DS PD 2 BI"), "OD -2.00 DS 2^ BI");
}

TEST(PrescriptionNotation, TheNoseIsOnEitherSide) {
  // As an examiner sees it: 0° is the examiner's right, where a right eye has its nose.
  const auto base = [](const char* text) {
    const Json object = prescription_object(read_notation(text, here), here);
    EXPECT_DOUBLE_EQ(object["prism_cm_per_m"].get<double>(), 2.0);
    return object["prism_base_deg"].get<double>();
  };
  EXPECT_DOUBLE_EQ(base("OD PL 2^ BI"), 0.0);
  EXPECT_DOUBLE_EQ(base("OS PL 2^ BI"), 180.0);
  EXPECT_DOUBLE_EQ(base("OD PL 2^ BO"), 180.0);
  EXPECT_DOUBLE_EQ(base("OS PL 2^ BO"), 0.0);
  EXPECT_DOUBLE_EQ(base("PL 2^ BU"), 90.0);
  EXPECT_DOUBLE_EQ(base("PL 2^ BD"), 270.0);
  EXPECT_DOUBLE_EQ(base("PL 2^ base 135"), 135.0);
  const Json oblique = prescription_object(read_notation("OS PL 3^ BI 4^ BD", here), here);
  EXPECT_DOUBLE_EQ(oblique["prism_cm_per_m"].get<double>(), 5.0);
  EXPECT_NEAR(oblique["prism_base_deg"].get<double>(), 233.13010235415598, 1e-12);  // 180° + atan(4/3)
  EXPECT_THAT(input_error([&] { prescription_object(read_notation("PL 2^ BI", here), here); }),
              AllOf(HasSubstr("x.json: /rx"), HasSubstr("OD or OS before a prism")));
}

TEST(PrescriptionNotation, WhatIsAmbiguousSaysHowItCouldBeRead) {
  EXPECT_THAT(refused("-2.00 / -1.50 @ 30"), AllOf(HasSubstr("\"x 30\""), HasSubstr("\"x 120\"")));
  EXPECT_THAT(refused("-200 -150 x 30"), AllOf(HasSubstr("-2.00 D"), HasSubstr("-200 D")));
  EXPECT_THAT(refused("-2.00 -75 x 30"), HasSubstr("-0.75 D"));
  EXPECT_THAT(refused("-075 DS"), HasSubstr("-0.75 D"));
  EXPECT_THAT(refused("-05 DS"), HasSubstr("a point in the sphere"));
  for (const char* text : {"sph.5", "-1.00 DS add.2", "OD.5"})
    EXPECT_THAT(refused(text), HasSubstr("the point may be its own"));
  EXPECT_THAT(refused("-1.00 DS add 200"), HasSubstr("+2.00 D"));
  EXPECT_THAT(refused("-2.00 x 30"),
              AllOf(HasSubstr("\"-2.00 DS\""), HasSubstr("\"PL -2.00 x 30\""), HasSubstr("if a cylinder is missing")));
  EXPECT_THAT(refused("-2.00 30"), HasSubstr("30 could be an axis"));
  // Bookkeepers write a minus behind the number.
  for (const char* text : {"1.00-", "2.00- 1.50- x 30", "1.- DS", "1.00\u2212", "-2.00 -1.50- x 30"})
    EXPECT_THAT(refused(text), HasSubstr("a sign before its number"));
}

TEST(PrescriptionNotation, WhatIsWrongIsRefused) {
  EXPECT_THAT(refused("piano"), HasSubstr("did you mean \"plano\"?"));
  EXPECT_THAT(refused("-2.00 -1.50"), AllOf(HasSubstr("an axis behind the cylinder"), HasSubstr("cylinder -1.50 D")));
  EXPECT_THAT(refused("-2.00 -1.50 x 181"), HasSubstr("an axis from 0 to 180, not \"181\""));
  EXPECT_THAT(refused("-2.00 -1.50 x -30"), HasSubstr("an axis from 0 to 180"));
  EXPECT_THAT(refused("-40.25 DS"), HasSubstr("at most 40 D"));
  EXPECT_THAT(refused("-1.00 DS 2^"), HasSubstr("where the base of the prism is"));
  for (const char* text :
       {"", " ", "x", "OD", "-2.00 -1.50 x", "-2.00 -1.50 x 30 40", "+-2.00", "-2.00 DS -1.00 DS", "ADD +2.00",
        "-2.00 -1.50 x 30 x 40", "OD -2.00 OD -2.00", "-2.00 ~ 30", "-1.00 DS 50^ BI", "-1.00 DS VD 60", "-1.00 DS VD",
        "cyl -1.50 sph x 30", "-2.00 @ 30 / -3.50 @ 110", "-1.00 DS add 11.00", "1e2"})
    refused(text);
  EXPECT_THAT(refused(std::string(500, '1')), HasSubstr("at most 400 bytes"));
  refused("\xFF\xFE\xFF");
}

TEST(PrescriptionNotation, ThePlaceMaySayWhichEye) {
  const char* both = "OD -1.00 DS OS -2.00 DS";
  EXPECT_EQ(read_notation(both, here, EyeSide::left).sphere_D, -2.0);
  EXPECT_EQ(read_notation(both, here, EyeSide::right).sphere_D, -1.0);
  EXPECT_THAT(input_error([&] { read_notation(both, here); }),
              AllOf(HasSubstr("x.json: /rx: got \"OD -1.00 DS OS -2.00 DS\""), HasSubstr("\"OS -2.00 DS\"")));
  EXPECT_THAT(input_error([&] { read_notation("OD -1.00 DS", here, EyeSide::left); }), HasSubstr("the left eye"));
  EXPECT_FALSE(read_notation("OU -1.00 DS", here).eye);
  EXPECT_EQ(eye_side("Right eye"), EyeSide::right);
  EXPECT_EQ(eye_side("os"), EyeSide::left);
  EXPECT_FALSE(eye_side("P12"));
}

TEST(PrescriptionNotation, StandsForTheObjectInDocuments) {
  const Json text = "OD -2.00 -1.50 x 30 VD 14 2^ BU";
  const Json object = {{"sphere_D", -2.0},           {"cylinder_D", -1.5},    {"axis_deg", 30.0},
                       {"vertex_distance_mm", 14.0}, {"prism_cm_per_m", 2.0}, {"prism_base_deg", 90.0}};
  const Prescription a = read_prescription(text, here), b = read_prescription(object, here);
  EXPECT_EQ(a.sphere_D, b.sphere_D);
  EXPECT_EQ(a.cylinder_D, b.cylinder_D);
  EXPECT_EQ(a.axis_deg, b.axis_deg);
  EXPECT_EQ(a.vertex_distance_m, b.vertex_distance_m);
  EXPECT_DOUBLE_EQ(a.prism_cm_per_m, b.prism_cm_per_m);
  EXPECT_DOUBLE_EQ(a.prism_base_deg, b.prism_base_deg);
  EXPECT_EQ(read_prescription("-2.00 -1.50 x 30", here).vertex_distance_m, 0.012);  // the schema's default

  const Json eye = {{"prescription", "OD -2.00 -1.50 x 30 ADD +2.00"}, {"pupil_diameter_mm", 4}};
  validate(eye, "eye", "eye.json");
  const EyeSpec spec = read_eye_spec(eye, {"eye.json", ""});
  EXPECT_EQ(spec.eye.prescription.axis_deg, 30.0);
  ASSERT_EQ(spec.notes.size(), 1u);
  EXPECT_THAT(spec.notes[0],
              AllOf(HasSubstr("/prescription is read as OD -2.00 -1.50 x 30 ADD +2.00"), HasSubstr("addition")));
}

RC_GTEST_PROP(PrescriptionNotation, WhatIsPrintedReadsBack, ()) {
  const auto number = [](int low, int high) { return 0.01 * *rc::gen::inRange(100 * low, 100 * high + 1); };
  NotedPrescription rx;
  rx.sphere_D = number(-40, 40), rx.cylinder_D = number(-40, 40);
  if (*rc::gen::arbitrary<bool>()) rx.eye = *rc::gen::arbitrary<bool>() ? EyeSide::right : EyeSide::left;
  if (rx.cylinder_D != 0.0 || *rc::gen::arbitrary<bool>()) rx.axis_deg = number(0, 180);
  if (*rc::gen::arbitrary<bool>()) rx.addition_D = number(-10, 10);
  if (*rc::gen::arbitrary<bool>()) rx.vertex_distance_mm = number(0, 50);
  if (*rc::gen::arbitrary<bool>()) rx.prism_nasal = number(-40, 40), rx.prism_up = number(-40, 40);
  if (*rc::gen::arbitrary<bool>()) rx.prism_right = number(-40, 40);
  const auto eyes = parse_prescription_notation(in_notation(rx));
  RC_ASSERT(eyes.size() == 1u);
  const NotedPrescription& back = eyes[0];
  RC_ASSERT(back.eye == rx.eye);
  RC_ASSERT(back.sphere_D == rx.sphere_D);
  RC_ASSERT(back.cylinder_D == rx.cylinder_D);
  RC_ASSERT(back.axis_deg == rx.axis_deg);
  RC_ASSERT(back.addition_D == rx.addition_D);
  RC_ASSERT(back.vertex_distance_mm == rx.vertex_distance_mm);
  RC_ASSERT(back.prism_nasal == rx.prism_nasal);
  RC_ASSERT(back.prism_up == rx.prism_up);
  RC_ASSERT(back.prism_right == rx.prism_right);
}

RC_GTEST_PROP(PrescriptionNotation, NoTextDoesHarm, ()) {
  const auto pieces = *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(std::vector<std::string>{
      "-2.00", "+1", "x",  "30", "OD", "OS", "OU", "add", "VD",  "^",   "BI", "base", "@",  "sph",
      "cyl",   "DS", "DC", "PL", "/",  ",",  "-",  "mm",  "deg", "1e9", "é",  "\xFF", "999"}));
  std::string text;
  for (const std::string& piece : pieces) text += piece + (*rc::gen::arbitrary<bool>() ? " " : "");
  try {
    for (const NotedPrescription& rx : parse_prescription_notation(text)) {
      RC_ASSERT(std::abs(rx.sphere_D) <= 40.0 && std::abs(rx.cylinder_D) <= 40.0);
      RC_ASSERT(rx.cylinder_D == 0.0 || (rx.axis_deg && *rx.axis_deg >= 0.0 && *rx.axis_deg <= 180.0));
    }
  } catch (const NotationError& error) {
    RC_ASSERT(std::string(error.what()).size() > 10u);
  }
}

}  // namespace
}  // namespace sturm
