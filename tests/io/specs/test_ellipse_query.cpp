#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "ellipse_query_testing.h"
#include "support/source_folder.h"

namespace sturm {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Json query() {
  return parse_json(R"({
    "format": "sturm.ellipse/1",
    "eye": {"prescription": {"sphere_D": -2.0, "cylinder_D": -1.5, "axis_deg": 30, "vertex_distance_mm": 0}, "pupil_diameter_mm": 4.0,
            "accommodation": {"mode": "fixed", "focus_distance_m": 2}},
    "targets": [{"gaze_deg": [20, -10], "distance_m": 0.5}, {"distance_m": "inf"}],
    "methods": ["conoid", "rays:power_matrix"],
    "seed": 7
  })",
                    "q.json");
}

EllipseQuery read_with(const std::vector<std::string>& assignments) {
  return query_with(query(), assignments);
}
std::string error_with(const std::vector<std::string>& assignments) {
  return query_error_with(query(), assignments);
}

TEST(EllipseQuery, ReadsIntoSi) {
  const EllipseQuery q = read_ellipse_query(query(), "q.json");
  EXPECT_EQ(q.eye.prescription.sphere_D, -2.0);
  EXPECT_EQ(q.eye.prescription.axis_deg, 30.0);
  EXPECT_DOUBLE_EQ(q.eye.pupil_radius_m, 2e-3);
  EXPECT_DOUBLE_EQ(q.eye.rotation_center_m, 13.5e-3);
  EXPECT_EQ(q.eye.accommodation_for(0.0), 0.5);
  EXPECT_EQ(q.eye.stated_focus_distance_m(), 2.0);
  // AXIS 30 lies at 150° for the wearer, the power acts at 240°: u = (−1/2, −√3/2), xy = C·uₓ·u_y = −1.5·√3/4.
  EXPECT_NEAR(q.eye.correction.xy(), -0.6495190528383290, 1e-15);
  ASSERT_EQ(q.targets.size(), 2u);
  EXPECT_NEAR(q.targets[0].azimuth, 0.3490658503988659, 1e-15);
  EXPECT_NEAR(q.targets[0].elevation, -0.17453292519943295, 1e-15);
  EXPECT_EQ(q.targets[0].distance_m, 0.5);
  EXPECT_TRUE(std::isinf(q.targets[1].distance_m));
  EXPECT_EQ(q.targets[1].azimuth, 0.0);
  EXPECT_THAT(q.methods, ElementsAre(ConoidMethod::conoid, RayModel::power_matrix));
  EXPECT_EQ(q.seed, 7u);
  EXPECT_EQ(q.rays.count, 65536u);
  EXPECT_EQ(q.rays.replicates, 16);
  EXPECT_EQ(q.rays.sequence, Sequence::Sobol);
  EXPECT_TRUE(q.notes.empty());
}

TEST(EllipseQuery, VertexDistanceDefaultsTo12Millimetres) {
  Json document = query();
  document["eye"]["prescription"].erase("vertex_distance_mm");
  EXPECT_DOUBLE_EQ(read_ellipse_query(document, "q.json").eye.prescription.vertex_distance_m, 12e-3);
}

TEST(EllipseQuery, ACylinderNeedsAnAxis) {
  Json document = query();
  document["eye"]["prescription"].erase("axis_deg");
  EXPECT_EQ(input_error([&] { read_ellipse_query(document, "q.json"); }),
            "q.json: /eye/prescription: got no \"axis_deg\", expected the AXIS of the cylinder [deg], from 0 to 180");
  document["eye"]["prescription"]["cylinder_D"] = 0;
  EXPECT_NO_THROW(read_ellipse_query(document, "q.json"));
}

TEST(EllipseQuery, VertexDistanceAtTheFocalLengthIsRefused) {
  // 1/(40 D) = 25 mm.
  EXPECT_THAT(error_with({"/eye/prescription={\"sphere_D\": 40, \"vertex_distance_mm\": 25}"}),
              AllOf(HasSubstr("q.json: /eye/prescription: got {\"sphere_D\":40"), HasSubstr("not a focal length")));
}

TEST(EllipseQuery, AccommodationModesTakeTheirOwnMembersOnly) {
  EXPECT_THAT(error_with({"/eye/accommodation={\"mode\": \"fixed\"}"}),
              AllOf(HasSubstr("/eye/accommodation: got {\"mode\":\"fixed\"}"), HasSubstr("exactly one of")));
  EXPECT_THAT(error_with({"/eye/accommodation/power_D=1"}),
              HasSubstr("exactly one of \"focus_distance_m\" and \"power_D\""));
  EXPECT_THAT(error_with({"/eye/accommodation/mode=relaxed"}),
              HasSubstr("/eye/accommodation/focus_distance_m: got 2, expected no"));
  EXPECT_THAT(error_with({"/eye/accommodation/age_years=50"}), HasSubstr("/eye/accommodation/age_years: got 50"));
  EXPECT_THAT(error_with({"/eye/accommodation={\"mode\": \"best\"}"}), HasSubstr("\"amplitude_D\" and \"age_years\""));
  EXPECT_THAT(error_with({"/eye/accommodation={\"mode\": \"best\", \"amplitude_D\": 1, \"power_D\": 1}"}),
              HasSubstr("/power_D"));
  EXPECT_THAT(error_with({"/eye/accommodation={\"mode\": \"fxed\", \"power_D\": 1}"}),
              HasSubstr("did you mean \"fixed\"?"));
  EXPECT_THAT(error_with({"/eye/accommodation/focus_distance_m=0"}),
              HasSubstr("/eye/accommodation/focus_distance_m: got 0"));
}

TEST(EllipseQuery, AccommodationValues) {
  EXPECT_EQ(read_with({"/eye/accommodation={\"mode\": \"fixed\", \"power_D\": 0.75}"}).eye.accommodation_for(3.0),
            0.75);
  EXPECT_EQ(read_with({"/eye/accommodation={\"mode\": \"fixed\", \"power_D\": 0.75}"}).eye.stated_focus_distance_m(),
            std::nullopt);
  const Eye at_infinity = read_with({"/eye/accommodation={\"mode\": \"fixed\", \"focus_distance_m\": \"inf\"}"}).eye;
  EXPECT_EQ(at_infinity.accommodation_for(3.0), 0.0);
  EXPECT_TRUE(std::isinf(*at_infinity.stated_focus_distance_m()));
  // Hofstetter: 18.5 − 0.3·50 = 3.5 D; the eye needs 10 + M = 7.25 D at 0.1 m.
  EXPECT_EQ(read_with({"/eye/accommodation={\"mode\": \"best\", \"age_years\": 50}"}).eye.accommodation_for(10.0), 3.5);
  EXPECT_EQ(read_with({"/eye/accommodation={\"mode\": \"best\", \"amplitude_D\": 1.25}"}).eye.accommodation_for(10.0),
            1.25);
}

TEST(EllipseQuery, RayBundles) {
  const EllipseQuery counted = read_with({"/rays={\"count\": 1024, \"replicates\": 4, \"sequence\": \"independent\"}"});
  EXPECT_EQ(counted.rays.count, 1024u);
  EXPECT_EQ(counted.rays.replicates, 4);
  EXPECT_EQ(counted.rays.sequence, Sequence::Independent);
  const EllipseQuery quadrature = read_with({"/rays/quadrature={\"radial\": 14, \"azimuthal\": 56}"});
  ASSERT_TRUE(quadrature.rays.quadrature);
  EXPECT_EQ(quadrature.rays.quadrature->radial, 14);
  EXPECT_EQ(quadrature.rays.quadrature->azimuthal, 56);
  const EllipseQuery points = read_with({"/rays/pupil_points_mm=[[2, 0], [-0.5, 1]]"});
  ASSERT_EQ(points.rays.pupil_points_m.size(), 2u);
  EXPECT_NEAR(points.rays.pupil_points_m[1].x(), -0.5e-3, 1e-18);
  EXPECT_NEAR(points.rays.pupil_points_m[1].y(), 1e-3, 1e-18);
}

TEST(EllipseQuery, RayBundleModesExcludeEachOther) {
  EXPECT_THAT(error_with({"/rays/quadrature={\"radial\": 14, \"azimuthal\": 56}", "/rays/count=4"}),
              HasSubstr("/rays/count: got 4, expected no \"count\" beside \"quadrature\""));
  EXPECT_THAT(error_with({"/rays/pupil_points_mm=[[0, 0]]", "/rays/replicates=4"}),
              HasSubstr("/rays/replicates: got 4"));
  EXPECT_THAT(error_with({"/rays/pupil_points_mm=[[0, 0]]", "/rays/quadrature={\"radial\": 14, \"azimuthal\": 56}"}),
              HasSubstr("either"));
  EXPECT_THAT(error_with({"/rays/pupil_points_mm=[[0, 0], [1.5, 1.5]]"}),
              HasSubstr("/rays/pupil_points_mm/1: got [1.5,1.5], expected a point in the pupil, at most 2.0 mm"));
  EXPECT_THAT(error_with({"/rays/sampling=polar"}), HasSubstr("/rays/sampling: got \"polar\""));
}

TEST(EllipseQuery, AWidePupilIsNoted) {
  EXPECT_THAT(read_with({"/eye/pupil_diameter_mm=40"}).notes,
              ElementsAre(HasSubstr("/eye/pupil_diameter_mm is 40 mm")));
  EXPECT_THAT(error_with({"/eye/pupil_diameter_mm=101"}), HasSubstr("got 101"));
  EXPECT_EQ(read_with({"/eye/pupil_diameter_mm=0"}).eye.pupil_radius_m, 0.0);
}

TEST(EllipseQuery, AnEyeCanHaveItsOwnFile) {
  const TemporaryFolder folder;
  Json eye = query()["eye"];
  write_text(folder / "eyes/e.json", eye.dump());
  Json document = query();
  document["eye"] = "../eyes/e.json";
  const std::string file = (folder / "queries/q.json").string();
  const EllipseQuery q = read_ellipse_query(document, file);
  EXPECT_EQ(q.eye.prescription.axis_deg, 30.0);
  EXPECT_THAT(q.input_files, ElementsAre((folder / "eyes/e.json").string()));

  eye["prescription"]["cylindr_D"] = 1;
  write_text(folder / "eyes/e.json", eye.dump());
  EXPECT_THAT(input_error([&] { read_ellipse_query(document, file); }),
              AllOf(HasSubstr("eyes/e.json: /prescription/cylindr_D"), HasSubstr("\"cylinder_D\"")));
  document["eye"] = "none.json";
  EXPECT_THAT(input_error([&] { read_ellipse_query(document, file); }),
              AllOf(HasSubstr("q.json: /eye: got \"none.json\""), HasSubstr("there is no file")));
  write_text(folder / "eyes/e.json", "\"../eyes/e.json\"");
  document["eye"] = "../eyes/e.json";
  EXPECT_THAT(input_error([&] { read_ellipse_query(document, file); }),
              HasSubstr("expected an object of format sturm.eye/1"));
}

TEST(EllipseQuery, TheExampleEyeIsRead) {
  const Eye eye = read_eye(Json("oblique_astigmat.json"), {STURM_SOURCE_DIR "/configs/eyes/x.json", ""});
  EXPECT_EQ(eye.prescription.cylinder_D, -1.5);
}

}  // namespace
}  // namespace sturm
