#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "io/io_testing.h"
#include "io/json/schema.h"
#include "io/json/suggest.h"
#include "support/source_folder.h"

namespace sturm {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Json query() {
  return parse_json(R"({
    "format": "sturm.ellipse/1",
    "eye": {"prescription": {"sphere_D": -2.0, "cylinder_D": -1.5, "axis_deg": 30}, "pupil_diameter_mm": 4.0},
    "targets": [{"gaze_deg": [0, 0], "distance_m": 1.0}, {"distance_m": "inf"}],
    "methods": ["conoid", "rays:power_matrix"]
  })",
                    "q.json");
}

std::string error_of(const Json& document, const std::string& schema = "ellipse") {
  return input_error([&] { validate(document, schema, "q.json"); });
}

std::string error_with(const std::string& pointer, const Json& value) {
  Json document = query();
  document[Json::json_pointer(pointer)] = value;
  return error_of(document);
}

void collect_refs(const Json& node, std::set<std::string>& refs) {
  if (node.is_object() && node.contains("$ref") && node["$ref"].is_string())
    refs.insert(node["$ref"].get<std::string>());
  if (node.is_structured())
    for (const Json& child : node) collect_refs(child, refs);
}

/// Calls `visit` for every schema of an object, an array element or a member, not for the root.
template <typename Visit>
void each_subschema(const Json& node, const std::string& place, Visit visit) {
  for (const char* group : {"properties", "definitions"})
    if (node.contains(group))
      for (const auto& [name, child] : node[group].items()) {
        visit(child, place + "/" + name);
        each_subschema(child, place + "/" + name, visit);
      }
  for (const char* key : {"items", "additionalProperties"})
    if (node.contains(key) && node[key].is_object()) {
      visit(node[key], place + "/" + key);
      each_subschema(node[key], place + "/" + key, visit);
    }
}

TEST(Schema, AllAreEmbeddedAndSelfContained) {
  EXPECT_THAT(schema_names(),
              ElementsAre("bench", "bench_report", "blurfield", "blurfield_result", "camera_check", "comparison",
                          "ellipse", "ellipse_result", "experiment", "eye", "gates", "lens_report", "manifest", "psf",
                          "psf_result", "render", "report", "run_comparison", "scene", "see", "spectacles",
                          "stress_report", "wavefront_report"));
  for (const std::string& name : schema_names()) {
    const Json schema = Json::parse(schema_text(name));
    EXPECT_EQ(schema["$schema"], "http://json-schema.org/draft-07/schema#") << name;
    EXPECT_EQ(schema["properties"]["format"]["const"], "sturm." + name + "/1") << name;
    std::set<std::string> refs;
    collect_refs(schema, refs);
    for (const std::string& ref : refs) {
      EXPECT_TRUE(ref.starts_with("#/definitions/")) << name << " " << ref;
      EXPECT_TRUE(schema.contains(Json::json_pointer(ref.substr(1)))) << name << " " << ref;
    }
  }
}

TEST(Schema, EveryPlaceIsDescribedAndEveryObjectIsClosed) {
  for (const auto& [file, text] : embedded_schemas()) {
    const Json schema = Json::parse(text);
    EXPECT_TRUE(schema.contains("title") && schema.contains("description")) << file;
    each_subschema(schema, std::string(file), [](const Json& node, const std::string& place) {
      if (node.contains("$ref")) return;
      // An item is described by its array.
      if (!place.ends_with("/items")) {
        EXPECT_TRUE(node.contains("description")) << place;
      }
      EXPECT_FALSE(node.contains("oneOf") || node.contains("anyOf")) << place;
      if (node.contains("properties")) {
        EXPECT_TRUE(node.contains("additionalProperties")) << place;
      }
    });
  }
}

TEST(Schema, UnknownNamesAndFormatsListTheKnownOnes) {
  EXPECT_EQ(format_of(query(), "q.json"), "ellipse");
  EXPECT_THAT(input_error([] { schema_text("elipse"); }), HasSubstr("did you mean \"ellipse\"?"));
  EXPECT_THAT(input_error([] {
                format_of({{"format", "sturm.elipse/1"}}, "q.json");
              }),
              AllOf(HasSubstr("q.json: /format: got \"sturm.elipse/1\" (did you mean \"sturm.ellipse/1\"?)"),
                    HasSubstr("sturm.render/1")));
  EXPECT_THAT(input_error([] { format_of({{"format", "sturm.ellipse/2"}}, "q.json"); }), HasSubstr("sturm.ellipse/1"));
  EXPECT_THAT(input_error([] { format_of(Json::object(), "q.json"); }), HasSubstr("got no \"format\""));
  EXPECT_THAT(input_error([] { format_of(Json(3), "q.json"); }), HasSubstr("q.json: got 3, expected an object"));
  EXPECT_THAT(input_error([] { format_of({{"format", 3}}, "q.json"); }), HasSubstr("/format: got 3"));
}

TEST(Schema, ValidDocumentsPass) {
  EXPECT_NO_THROW(validate(query(), "ellipse", "q.json"));
  Json with_schema = query();
  with_schema["$schema"] = "../schemas/ellipse.schema.json";
  with_schema["spectacles"] = nullptr;
  EXPECT_NO_THROW(validate(with_schema, "ellipse", "q.json"));
}

TEST(Schema, UnknownKeysComeFirstAndWithASuggestion) {
  Json document = query();
  document["eye"]["prescription"]["spere_D"] = -1;
  document["eye"].erase("pupil_diameter_mm");  // also wrong, but the misspelt key tells more
  EXPECT_EQ(error_of(document),
            "q.json: /eye/prescription/spere_D: got an unknown key (did you mean \"sphere_D\"?), expected one of "
            "\"axis_deg\", "
            "\"cylinder_D\", \"prism_base_deg\", \"prism_cm_per_m\", "
            "\"sphere_D\", \"vertex_distance_mm\"");
  EXPECT_THAT(error_with("/targets/1/distance_mm", 3),
              HasSubstr("/targets/1/distance_mm: got an unknown key (did you mean \"distance_m\"?)"));
  EXPECT_THAT(error_with("/zzz", 3),
              AllOf(HasSubstr("/zzz: got an unknown key, expected one of"), HasSubstr("\"targets\"")));
}

TEST(Schema, ViolationsNamePlaceValueAndExpectation) {
  EXPECT_EQ(error_with("/eye/pupil_diameter_mm", -4),
            "q.json: /eye/pupil_diameter_mm: got -4, expected a number from 0 to 100 (diameter of the pupil [mm]; 0 is "
            "a pinhole)");
  EXPECT_EQ(error_with("/eye/pupil_diameter_mm", "4"),
            "q.json: /eye/pupil_diameter_mm: got \"4\", expected a number from 0 to 100 (diameter of the pupil [mm]; 0 "
            "is a pinhole)");
  EXPECT_EQ(error_with("/targets/1/distance_m", "infinity"),
            "q.json: /targets/1/distance_m: got \"infinity\", expected a number from 1e-06 to 1000000000000.0 or "
            "\"inf\" (distance from "
            "the pupil's centre along the line of sight [m]; with spectacles from the front surface along the outgoing "
            "chief ray)");
  EXPECT_THAT(error_with("/targets/0/distance_m", 0), HasSubstr("/targets/0/distance_m: got 0, expected a number"));
  EXPECT_THAT(error_with("/targets/0/gaze_deg", {0, 0, 0}),
              HasSubstr("/targets/0/gaze_deg: got [0,0,0], expected an array of 2 items"));
  EXPECT_THAT(error_with("/targets/0/gaze_deg/1", 89.5),
              HasSubstr("/targets/0/gaze_deg/1: got 89.5, expected a number from -89 to 89"));
  EXPECT_THAT(error_with("/targets", Json::array()),
              HasSubstr("/targets: got [], expected an array of 1 to 1000000 items"));
  EXPECT_THAT(
      error_with("/methods/1", "rays:powermatrix"),
      HasSubstr(
          "/methods/1: got \"rays:powermatrix\" (did you mean \"rays:power_matrix\"?), expected one of \"conoid\""));
  EXPECT_THAT(error_with("/methods", {"conoid", "conoid"}), HasSubstr("no two alike"));
  EXPECT_THAT(
      error_with("/spectacles", 3),
      HasSubstr(
          "/spectacles: got 3, expected an object or a string that is not empty or null (one thick spectacle lens"));
  EXPECT_THAT(error_with("/seed", 1.5), HasSubstr("/seed: got 1.5, expected an integer from 0 to 9007199254740991"));
  EXPECT_THAT(error_with("/seed", -1), HasSubstr("/seed: got -1"));
  EXPECT_THAT(error_with("/eye", 3), HasSubstr("/eye: got 3, expected an object or a string"));
  EXPECT_THAT(error_with("/rays", {{"count", 67108865}}), HasSubstr("/rays/count: got 67108865"));
  EXPECT_THAT(error_with("/format", "sturm.render/1"), HasSubstr("expected \"sturm.ellipse/1\""));
}

TEST(Schema, MissingMembersAreDescribed) {
  Json document = query();
  document["eye"].erase("pupil_diameter_mm");
  EXPECT_EQ(error_of(document),
            "q.json: /eye: got no \"pupil_diameter_mm\", expected \"pupil_diameter_mm\": a number from 0 to 100 "
            "(diameter of the pupil "
            "[mm]; 0 is a pinhole)");
  document = query();
  document.erase("targets");
  EXPECT_THAT(error_of(document), HasSubstr("got no \"targets\""));
}

TEST(Schema, LongValuesAreCut) {
  const std::string message = error_with("/eye/pupil_diameter_mm", std::string(1000, 'x'));
  EXPECT_LT(message.size(), 250u);
}

TEST(Schema, AConfigurationFilesFormatHolds) {
  int checked = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(STURM_SOURCE_DIR "/configs")) {
    if (entry.path().extension() != ".json" || entry.path().parent_path().filename() == "schemas") continue;
    const std::string file = entry.path().string();
    const Json document = load_json(file);
    if (entry.path().parent_path().filename() == "data") continue;  // measured data in formats of their own
    EXPECT_NO_THROW(validate(document, format_of(document, file), file)) << file;
    ++checked;
  }
  EXPECT_GE(checked, 1);
}

TEST(Schema, DefaultsAreSpeltOut) {
  const Json filled = with_defaults(query(), "ellipse");
  EXPECT_EQ(filled["seed"], 1);
  EXPECT_EQ(filled["spectacles"], nullptr);
  EXPECT_EQ(filled["rays"]["count"], 65536);
  EXPECT_EQ(filled["eye"]["prescription"]["vertex_distance_mm"], 12);
  EXPECT_EQ(filled["eye"]["accommodation"]["mode"], "relaxed");
  EXPECT_EQ(filled["targets"][1]["gaze_deg"], (Json{0, 0}));
  EXPECT_EQ(filled["eye"]["prescription"]["sphere_D"], -2.0);
  EXPECT_NO_THROW(validate(filled, "ellipse", "filled"));
  EXPECT_EQ(with_defaults(filled, "ellipse"), filled);
}

TEST(Suggestion, TakesTypingErrorsAndOtherUnits) {
  EXPECT_EQ(edit_distance("abcd", "acbd"), 1);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(suggestion("sphere", {"sphere_D", "cylinder_D"}), "sphere_D");
  EXPECT_EQ(suggestion("Sphere_d", {"sphere_D", "cylinder_D"}), "sphere_D");
  EXPECT_EQ(suggestion("focus_distance", {"mode", "focus_distance_m"}), "focus_distance_m");
  EXPECT_EQ(suggestion("colour", {"sphere_D", "cylinder_D"}), std::nullopt);
  EXPECT_EQ(suggestion("abc", {"xyz"}), std::nullopt);
}

}  // namespace
}  // namespace sturm
