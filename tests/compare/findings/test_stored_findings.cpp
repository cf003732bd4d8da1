#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compare/findings/ellipses.h"
#include "compare/findings/gate_power.h"
#include "compare/findings/must_fail.h"
#include "compare/findings/psfs.h"
#include "compare/findings/reference.h"
#include "compare/findings/sin2.h"
#include "compare/gates/gate_result.h"
#include "compare/gates/verdict.h"
#include "support/source_folder.h"

namespace sturm {
namespace {

/// An excerpt of a report that a run of configs/experiments/validation.json stored (its provenance says which program).
const Json& stored() {
  static const Json report = load_json(STURM_SOURCE_DIR "/tests/reference/reports/validation.json");
  return report;
}

TEST(StoredFindings, AreWrittenAsTheyWereRead) {
  EXPECT_EQ(to_json(read_ellipses(stored())), stored()["ellipses"]);
  EXPECT_EQ(to_json(read_psfs(stored())), stored()["psfs"]);
  EXPECT_EQ(to_json(read_sin2(stored()).value()), stored()["sin2"]);
  EXPECT_EQ(to_json(read_reference(stored())), stored()["reference"]);
  EXPECT_EQ(to_json(read_must_fail(stored())), stored()["must_fail"]);
  EXPECT_EQ(to_json(read_gate_power(stored())), stored()["gate_power"]);
  EXPECT_EQ(to_json(read_gate_results(stored())), stored()["gates"]);
  EXPECT_EQ(to_json(read_verdict(stored())), stored()["verdict"]);
}

TEST(StoredFindings, ReadNumbersWhereTheyStand) {
  const EllipseFindings ellipses = read_ellipses(stored());
  EXPECT_EQ(ellipses.conditions.replicates, 64u);
  const EllipseFinding& first = ellipses.cases.at(0);
  EXPECT_EQ(first.id, "P069-OS|0.4 m|3 mm");
  EXPECT_EQ(first.cylinder_D, -1.25);
  EXPECT_EQ(first.distance_m, 0.4);
  ASSERT_EQ(first.rays.size(), 5u);
  EXPECT_EQ(first.rays[1].model, RayModel::thin_lens);
  EXPECT_EQ(first.rays[1].counts->launched, 1048576u);
  EXPECT_EQ(first.conoid.ellipse->semi_major, 0.00911374887488749);
  EXPECT_EQ((*first.conoid.covariance_rad2)(0, 1), 3.210090800824734e-06);
  EXPECT_EQ((*first.conoid.covariance_rad2)(1, 0), 3.210090800824734e-06);
  EXPECT_EQ(first.rays_of(RayModel::sin2_radial)->own_agreement().z_max,
            first.rays_of(RayModel::sin2_radial)->against_closed_form->z_max);
  const PsfFinding spot = read_psfs(stored()).at(0);
  EXPECT_EQ(spot.measured->ellipse->semi_minor, 9.826422825005832);
  EXPECT_EQ(spot.measured->centroid_arcmin->y(), -0.06511917765852318);
  EXPECT_EQ(spot.resolution, 96u);
}

/// The same report with every leaf and every list in it replaced by something of another type.
Json mistyped(const Json& json) {
  if (json.is_object()) {
    Json result = Json::object();
    for (const auto& [key, value] : json.items()) result[key] = mistyped(value);
    return result;
  }
  if (json.is_array() && !json.empty() && json[0].is_object()) {
    Json result = Json::array({1, nullptr});
    for (const Json& value : json) result.push_back(mistyped(value));
    return result;
  }
  return json.is_string() ? Json(true) : Json("a word");  // a number would be a distance in place of "inf"
}

TEST(StoredFindings, WhatIsOfAnotherTypeIsNone) {
  const Json foreign = mistyped(stored());
  for (const Json& report :
       {foreign, Json(nullptr), Json(3), Json::array({1}), Json{{"ellipses", 3}, {"psfs", "none"}}}) {
    const EllipseFindings ellipses = read_ellipses(report);
    EXPECT_FALSE(ellipses.conditions.replicates);
    for (const EllipseFinding& finding : ellipses.cases) {
      EXPECT_EQ(finding.id, "");
      EXPECT_FALSE(finding.cylinder_D || finding.distance_m || finding.conoid.ellipse ||
                   finding.conoid.covariance_rad2);
      for (const RayFinding& rays : finding.rays) {
        EXPECT_FALSE(rays.model || rays.status || rays.counts || rays.ellipse || rays.covariance_rad2);
        EXPECT_FALSE(rays.own_agreement().z_max);
      }
    }
    for (const PsfFinding& psf : read_psfs(report)) {
      EXPECT_FALSE(psf.ray_model || psf.predicted || psf.bundle || psf.pixel_arcmin || psf.resolution);
      EXPECT_FALSE(psf.measured && (psf.measured->ellipse || psf.measured->centroid_arcmin || psf.measured->hits));
    }
    for (const auto& [quantity, error] : read_reference(report).max_relative_error) EXPECT_FALSE(error) << quantity;
    for (const MutantFinding& mutant : read_must_fail(report)) EXPECT_FALSE(mutant.failed_as_it_must || mutant.value);
    for (const NoticedMutation& mutation : read_gate_power(report).mutations)
      for (const GateThatNoticed& gate : mutation.caught_by) EXPECT_FALSE(gate.value || gate.bound);
    for (const GateResult& gate : read_gate_results(report)) {
      EXPECT_FALSE(gate.kind || gate.value || gate.bound || gate.cases || gate.has_passed());
      EXPECT_FALSE(gate_of(gate));
    }
    EXPECT_FALSE(read_verdict(report).passed);
    EXPECT_EQ(read_verdict(report).finding("sin2_sentence"), "");
    if (const auto sin2 = read_sin2(report)) {
      EXPECT_FALSE(sin2->cases_with_cylinder);
      for (const Sin2Case& c : sin2->table) EXPECT_FALSE(c.high_D || c.true_semi_axes_arcmin || c.ratio_major);
    }
  }
}

TEST(StoredFindings, AnInfiniteDistanceIsItsWord) {
  EllipseFinding finding;
  finding.distance_m = std::numeric_limits<double>::infinity();
  const Json json = to_json(finding);
  EXPECT_EQ(json["distance_m"], "inf");
  EXPECT_EQ(read_ellipses({{"ellipses", {{"cases", {json}}}}}).cases.at(0).distance_m, finding.distance_m);
}

TEST(StoredFindings, RaysWithoutAResultHaveNoNumbers) {
  EllipseFinding finding;
  finding.rays.resize(1);
  finding.rays[0].model = RayModel::metalstigmatism;
  finding.rays[0].status = RayStatus::Undefined;
  const Json rays = to_json(finding)["rays"][0];
  EXPECT_EQ(rays["status"], "undefined");
  EXPECT_FALSE(rays.contains("counters"));  // it was never asked for rays
  for (const char* key : {"semi_axes_rad", "covariance_rad2", "against_conoid", "against_closed_form"})
    EXPECT_TRUE(rays.at(key).is_null()) << key;
}

TEST(StoredFindings, WhatMutationsMakeOfThemStandsBesideThem) {
  EllipseFinding finding;
  finding.id = "A";
  EXPECT_FALSE(to_json(finding).contains("mutated"));
  EllipseFinding other = finding;
  other.cylinder_D = -1.0;
  finding.mutated.emplace("long", other);
  EXPECT_EQ(to_json(finding)["mutated"]["long"], to_json(other));
  PsfFinding psf;
  psf.mutated.emplace("moved", PsfFinding{});
  EXPECT_EQ(to_json(std::vector{psf})[0]["mutated"]["moved"], to_json(std::vector{PsfFinding{}})[0]);
}

}  // namespace
}  // namespace sturm
