#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "experiments/standard/ellipse_findings.h"
#include "experiments/standard/sin2_findings.h"

namespace sturm {
namespace {

/// A prescription with an oblique cylinder and one without, far out of focus.
EllipseExperiment experiment() {
  EllipseExperiment spec;
  spec.prescriptions = {{"oblique", "", {-3.0, -1.5, 30.0, 0.012}}, {"round", "", {-2.0, 0.0, 180.0, 0.012}}};
  spec.distances_m = {1.0, std::numeric_limits<double>::infinity()};
  spec.pupil_diameters_m = {4e-3};
  spec.accommodation = RelaxedAccommodation{};
  spec.ray_models = {RayModel::thin_lens, RayModel::metalstigmatism, RayModel::sin2_radial, RayModel::power_matrix};
  spec.rays.count = 4096;
  spec.rays.replicates = 8;
  return spec;
}

const std::vector<TracedCase>& traced() {
  static const std::vector<TracedCase> cases = traced_cases(experiment(), 1, [](double) {});
  return cases;
}

EllipseFindings with_mutations(const std::vector<std::string>& names) {
  const std::vector<Mutation> mutations = mutations_named(names);
  return ellipse_findings(experiment(), traced(), mutations);
}

const RayFinding& rays(const EllipseFinding& finding, RayModel model) {
  return *finding.rays_of(model);
}

TEST(EllipseFindings, NameTheirCasesInOrder) {
  std::vector<std::string> ids;
  for (const EllipseFinding& finding : with_mutations({}).cases) ids.push_back(finding.id);
  EXPECT_THAT(ids, ::testing::ElementsAre("oblique|1 m|4 mm", "oblique|inf|4 mm", "round|1 m|4 mm", "round|inf|4 mm"));
}

TEST(EllipseFindings, MatrixRaysAgreeWithTheConoidAndUndefinedModelsHaveNone) {
  const EllipseFinding finding = with_mutations({}).cases[0];
  EXPECT_EQ(finding.vertex_distance_mm, 12.0);
  EXPECT_EQ(finding.pupil_mm, 4.0);
  EXPECT_LT(rays(finding, RayModel::power_matrix).own_agreement().relative_frobenius.value(), 1e-4);
  EXPECT_GT(rays(finding, RayModel::sin2_radial).against_conoid->agreement.relative_frobenius.value(), 0.01);
  EXPECT_LT(rays(finding, RayModel::sin2_radial).own_agreement().relative_frobenius.value(), 1e-4);
  EXPECT_TRUE(rays(finding, RayModel::power_matrix).against_conoid->differences);
  EXPECT_EQ(rays(finding, RayModel::metalstigmatism).status, RayStatus::Undefined);  // no focus distance is stated
  EXPECT_FALSE(rays(finding, RayModel::metalstigmatism).counts);
}

TEST(EllipseFindings, AMutationChangesOnePredictorAlone) {
  const EllipseFinding honest = with_mutations({}).cases[0];
  const EllipseFindings all = with_mutations({"semi_axis", "mirrored_axis", "tangential_term", "lost_light"});
  const auto& mutated = all.cases[0].mutated;
  EXPECT_EQ(mutated.size(), 3u);  // light is none of ellipses
  // 1 % of the longer semi-axis: the traced rays and the closed form of sin² stay.
  const EllipseFinding& longer = mutated.at("semi_axis");
  EXPECT_NEAR(longer.conoid.ellipse->semi_major, 1.01 * honest.conoid.ellipse->semi_major, 1e-12);
  EXPECT_EQ(longer.sin2_closed_form.covariance_rad2, honest.sin2_closed_form.covariance_rad2);
  EXPECT_EQ(rays(longer, RayModel::power_matrix).covariance_rad2, rays(honest, RayModel::power_matrix).covariance_rad2);
  EXPECT_GT(rays(longer, RayModel::power_matrix).own_agreement().relative_frobenius.value(), 0.01);
  EXPECT_EQ(rays(longer, RayModel::sin2_radial).own_agreement().z_max,
            rays(honest, RayModel::sin2_radial).own_agreement().z_max);
  // A mirrored axis turns both closed forms.
  const EllipseFinding& mirrored = mutated.at("mirrored_axis");
  EXPECT_NEAR(*mirrored.conoid.ellipse->orientation_deg, -*honest.conoid.ellipse->orientation_deg, 1e-9);
  EXPECT_GT(rays(mirrored, RayModel::sin2_radial).own_agreement().relative_frobenius.value(), 0.01);
  // Without the tangential term sin² rays pass for matrix rays, and there are no others.
  const EllipseFinding& dropped = mutated.at("tangential_term");
  EXPECT_EQ(dropped.rays.size(), honest.rays.size());
  EXPECT_EQ(rays(dropped, RayModel::power_matrix).covariance_rad2, rays(honest, RayModel::sin2_radial).covariance_rad2);
  EXPECT_EQ(rays(dropped, RayModel::power_matrix).own_agreement().z_max,
            rays(honest, RayModel::sin2_radial).against_conoid->agreement.z_max);
}

/// Largest relative error of the covariance between matrix rays and the conoid, with one of them as the mutation has
/// it.
double worst_error(const std::string& mutation) {
  double worst = 0.0;
  for (const EllipseFinding& finding : with_mutations({mutation}).cases)
    worst =
        std::max(worst, *rays(finding.mutated.at(mutation), RayModel::power_matrix).own_agreement().relative_frobenius);
  return worst;
}

TEST(EllipseFindings, DeliberateErrorsAreFarBeyondWhatTwoPredictorsMayDifferBy) {
  // 0.005: a hundred times what honest matrix rays show here.
  for (const char* mutation : {"mirrored_axis", "vertex_distance", "tangential_term"})
    EXPECT_GT(worst_error(mutation), 0.005) << mutation;
  // sin² against wavefront theory, from the findings themselves.
  double worst = 0.0;
  for (const EllipseFinding& finding : with_mutations({}).cases)
    worst = std::max(worst, *rays(finding, RayModel::sin2_radial).against_conoid->agreement.relative_frobenius);
  EXPECT_NEAR(worst_error("tangential_term"), worst, 1e-12);
}

TEST(EllipseFindings, WithoutRaysThereIsNothingToNotice) {
  std::vector<TracedCase> cases = traced();
  for (TracedCase& c : cases) c.rays.clear();
  const std::vector<Mutation> mutations = mutations_named(std::vector<std::string>{"mirrored_axis"});
  for (const EllipseFinding& finding : ellipse_findings(experiment(), cases, mutations).cases)
    EXPECT_TRUE(finding.mutated.at("mirrored_axis").rays.empty()) << finding.id;
}

TEST(Sin2Findings, CountCasesWithACylinderAlone) {
  const Sin2Findings sin2 = sin2_findings(traced());
  EXPECT_EQ(sin2.cases_with_cylinder, 2u);
  ASSERT_EQ(sin2.table.size(), 2u);
  EXPECT_EQ(sin2.table[0].id, "oblique|1 m|4 mm");
  // By hand: vergences at the cornea for 12 mm, −3/1.036 and −4.5/1.054 D, and 1 D of the target.
  EXPECT_NEAR(sin2.table[0].high_D.value(), 1.0 - 3.0 / 1.036, 1e-12);
  EXPECT_NEAR(sin2.table[0].low_D.value(), 1.0 - 4.5 / 1.054, 1e-12);
  EXPECT_NEAR(sin2.ratio->measured_median.value(), 0.5, 1e-3);
  EXPECT_THAT(sin2_sentence(sin2).value(), ::testing::HasSubstr("In 2 cases with cylinder, sin² interpolation"));
  EXPECT_FALSE(sin2_sentence(sin2_findings(std::span(traced()).subspan(2))));  // the round eye's
}

}  // namespace
}  // namespace sturm
