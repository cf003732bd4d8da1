#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compare/studies/sin2/sin2_study_cases.h"
#include "compare/studies/sin2/summary.h"

namespace sturm {
namespace {

using namespace testing;
using enum StudyQuantity;
using enum RayModel;

constexpr double rounding = 1e-12;  // a quotient and a difference of numbers of the order of 1

Json check(const char* name, const std::vector<StudyCase>& cases) {
  return to_json(study_checks(sin2_spec(), cases)).at(name);
}

double value_of(const char* name, const std::vector<StudyCase>& cases) {
  return check(name, cases).at("value").get<double>();
}

/// A case of sin² with a cylinder (it has a share of lost variance) and principal values V₁ ≥ V₂.
StudyCase astigmatic(double high_D, double low_D, Numbers numbers = {}) {
  StudyCase c = study_case(sin2_radial, toric_eye, numbers);
  c[StudyQuantity::high_D] = high_D;
  c[StudyQuantity::low_D] = low_D;
  if (!c[lost_variance_ratio]) c[lost_variance_ratio] = 1.0;
  if (!c[error_D]) c[error_D] = 0.5;
  return c;
}

TEST(Sin2Checks, EachTakesTheLargestOfItsOwnModel) {
  const std::vector<StudyCase> cases = {
      study_case(power_matrix, round_eye, {{theory_deviation, 1e-15}, {closed_form_deviation, 0.7}}),
      study_case(power_matrix, toric_eye, {{theory_deviation, 3e-15}, {closed_form_deviation, 0.7}}),
      study_case(sin2_radial, round_eye,
                 {{theory_deviation, 2e-16},
                  {closed_form_deviation, 4e-14},
                  {radial_deviation_D, 5e-13},
                  {repaired_deviation, 8e-15}}),
      study_case(sin2_radial, round_eye,
                 {{theory_deviation, 1e-16},
                  {closed_form_deviation, 2e-14},
                  {radial_deviation_D, 6e-13},
                  {repaired_deviation, 9e-15}}),
      study_case(metalstigmatism, round_eye, {{theory_deviation, 0.8}, {closed_form_deviation, 7e-9}})};
  const Json checks = to_json(study_checks(sin2_spec(), cases));
  EXPECT_EQ(checks["cases"]["value"], 5);
  EXPECT_EQ(checks["matrix_vs_theory_max"]["value"], 3e-15);
  EXPECT_EQ(checks["matrix_vs_theory_max"]["cases"], 2);
  EXPECT_EQ(checks["matrix_vs_theory_max"]["worst_case"], "toric|1 m|4 mm|relaxed|power_matrix");
  EXPECT_EQ(checks["sin2_vs_closed_form_max"]["value"], 4e-14);
  EXPECT_EQ(checks["metalstigmatism_vs_closed_form_max"]["value"], 7e-9);
  EXPECT_EQ(checks["metalstigmatism_vs_closed_form_max"]["cases"], 1);
  EXPECT_EQ(checks["sin2_radial_part_max_D"]["value"], 6e-13);
  EXPECT_EQ(checks["sin2_without_cylinder_max"]["value"], 2e-16);
  EXPECT_EQ(checks["sin2_without_cylinder_max"]["cases"], 2);
  EXPECT_EQ(checks["repaired_vs_theory_max"]["value"], 9e-15);
  // Nobody was asked: no value, which fails a gate.
  EXPECT_TRUE(checks["sin2_lost_variance_max_deviation"]["value"].is_null());
  EXPECT_EQ(checks["sin2_lost_variance_max_deviation"]["cases"], 0);
  EXPECT_TRUE(checks["sin2_lost_variance_max_deviation"]["worst_case"].is_null());
}

TEST(Sin2Checks, ACylinderIsNoCaseWithoutOne) {
  const std::vector<StudyCase> cases = {study_case(sin2_radial, round_eye, {{theory_deviation, 1e-16}}),
                                        astigmatic(2.0, 1.0, {{theory_deviation, 0.3}})};
  EXPECT_EQ(value_of("sin2_without_cylinder_max", cases), 1e-16);
  EXPECT_EQ(check("sin2_error_per_cylinder_max", cases)["cases"], 1);
}

TEST(Sin2Checks, OneCaseWithoutANumberLeavesNoneAndIsNamed) {
  const std::vector<StudyCase> cases = {study_case(power_matrix, round_eye, {{theory_deviation, 0.5}}),
                                        study_case(power_matrix, first_real_eye, {}),
                                        study_case(power_matrix, toric_eye, {{theory_deviation, 0.9}})};
  const Json result = check("matrix_vs_theory_max", cases);
  EXPECT_TRUE(result["value"].is_null());
  EXPECT_EQ(result["cases"], 3);
  EXPECT_EQ(result["worst_case"], "A OD|1 m|4 mm|relaxed|power_matrix");
}

TEST(Sin2Checks, PolesAndUndefinedCasesAreNotAsked) {
  const Numbers wrong = {{closed_form_deviation, 0.5}, {polar_rms, 9.0}};
  const std::vector<StudyCase> cases = {study_case(metalstigmatism, toric_eye, wrong, StudyStatus::pole),
                                        study_case(metalstigmatism, toric_eye, wrong, StudyStatus::undefined),
                                        study_case(sin2_radial, round_eye, {{polar_rms, 8.0}}, StudyStatus::pole),
                                        study_case(metalstigmatism, toric_eye, {{closed_form_deviation, 1e-7}})};
  EXPECT_EQ(value_of("metalstigmatism_vs_closed_form_max", cases), 1e-7);
  EXPECT_EQ(check("metalstigmatism_vs_closed_form_max", cases)["cases"], 1);
  EXPECT_EQ(check("polar_rms_max_deviation", cases)["cases"], 0);
}

TEST(Sin2Checks, SharesDeviateToBothSides) {
  // From ½: 0.02 below, then 0.03 above; from 1: 0.04 above, then 0.05 below.
  std::vector<StudyCase> cases = {astigmatic(2.0, 1.0, {{difference_ratio, 0.48}, {lost_variance_ratio, 1.04}})};
  EXPECT_NEAR(value_of("sin2_half_difference_max_deviation", cases), 0.02, rounding);
  EXPECT_NEAR(value_of("sin2_lost_variance_max_deviation", cases), 0.04, rounding);
  cases.push_back(astigmatic(2.0, 1.0, {{difference_ratio, 0.53}, {lost_variance_ratio, 0.95}}));
  EXPECT_NEAR(value_of("sin2_half_difference_max_deviation", cases), 0.03, rounding);
  EXPECT_NEAR(value_of("sin2_lost_variance_max_deviation", cases), 0.05, rounding);
  // A circle has no difference of variances and is not asked.
  cases.push_back(astigmatic(1.0, -1.0));
  EXPECT_EQ(check("sin2_half_difference_max_deviation", cases)["cases"], 2);
}

TEST(Sin2Checks, ErrorsArePerDioptreBetweenThePrincipalValues) {
  // 0.3 D of 2 D, 0.5 D of 4 D, 0.2 D of 0.5 D: 0.15, 0.125, 0.4. The difference of V₁ and V₂, whatever their signs.
  const std::vector<StudyCase> cases = {astigmatic(2.0, 0.0, {{error_D, 0.3}}), astigmatic(1.0, -3.0, {{error_D, 0.5}}),
                                        astigmatic(-1.0, -1.5, {{error_D, 0.2}})};
  EXPECT_NEAR(value_of("sin2_error_per_cylinder_min", cases), 0.125, rounding);
  EXPECT_NEAR(value_of("sin2_error_per_cylinder_max", cases), 0.4, rounding);
  // Without a difference there is no quotient.
  EXPECT_TRUE(check("sin2_error_per_cylinder_max", {astigmatic(1.0, 1.0)})["value"].is_null());
}

TEST(Sin2Checks, LineFocusIsWhereOnePrincipalValueVanishes) {
  // √(5/8) = 0.790569 of the length, √(1/8) = 0.353553 of the width; 7.8 and 3.6 of 10 arcmin.
  const Numbers measured = {{true_major_arcmin, 10.0}, {major_arcmin, 7.8}, {minor_arcmin, 3.6}};
  const double length = 0.7905694150420949 - 0.78, width = 0.36 - 0.3535533905932738;
  for (const auto& [high, low] : {std::pair{2.0, 0.0}, {0.0, -2.0}, {2.0, 1e-9}, {-1e-9, -2.0}}) {
    EXPECT_NEAR(value_of("line_focus_length_max_deviation", {astigmatic(high, low, measured)}), length, rounding)
        << high << " " << low;
    EXPECT_NEAR(value_of("line_focus_width_max_deviation", {astigmatic(high, low, measured)}), width, rounding)
        << high << " " << low;
  }
  for (const auto& [high, low] : {std::pair{2.0, 1.0}, {2.0, 1e-8}, {1e-8, -2.0}, {0.0, 0.0}, {1.0, -1.0}})
    EXPECT_EQ(check("line_focus_length_max_deviation", {astigmatic(high, low, measured)})["cases"], 0)
        << high << " " << low;
  // Longer than it should be counts as much.
  EXPECT_NEAR(value_of("line_focus_length_max_deviation",
                       {astigmatic(2.0, 0.0, {{true_major_arcmin, 10.0}, {major_arcmin, 8.0}, {minor_arcmin, 3.6}})}),
              0.8 - 0.7905694150420949, rounding);
}

TEST(Sin2Checks, CircleOfLeastConfusionIsWherePrincipalValuesAreOpposite) {
  const Numbers measured = {{true_major_arcmin, 10.0}, {major_arcmin, 7.0}};
  const std::vector<StudyCase> circle = {astigmatic(1.5, -1.5, measured)};
  EXPECT_NEAR(value_of("circle_radius_max_deviation", circle), 0.7071067811865476 - 0.7, rounding);
  for (const auto& [high, low] : {std::pair{1.5, 1.5}, {1.5, -1.4}, {-1.5, -1.5}, {0.0, 0.0}})
    EXPECT_EQ(check("circle_radius_max_deviation", {astigmatic(high, low, measured)})["cases"], 0)
        << high << " " << low;
  EXPECT_TRUE(check("circle_radius_max_deviation", {astigmatic(1.5, -1.5, {{major_arcmin, 7.0}})})["value"].is_null());
}

TEST(Sin2Checks, EmmetropeFocusedAsPrintedSeesInfinity) {
  // Error × distance should be 1: 1.02 D at 1 m, then 1.94 D at half a metre (0.97).
  const StudyCase near = study_case(metalstigmatism, round_eye, {{error_D, 1.02}}),
                  nearer = study_case(metalstigmatism, round_eye, {{error_D, 1.94}});
  std::vector<StudyCase> cases = {seen(near, at_1_m, focus_1_m)};
  EXPECT_NEAR(value_of("emmetrope_focused_at_infinity_max_deviation", cases), 0.02, rounding);
  cases.push_back(seen(nearer, at_half_a_metre, focus_half_a_metre));
  EXPECT_NEAR(value_of("emmetrope_focused_at_infinity_max_deviation", cases), 0.03, rounding);
  // Elsewhere than at its focus, without one, at infinity, with any prescription or by another model nobody is asked.
  StudyCase toric = near, sphere = near, other = near;
  toric.eye = toric_eye;
  sphere.eye = second_real_eye;
  other.model = sin2_radial;
  EXPECT_EQ(
      check("emmetrope_focused_at_infinity_max_deviation",
            {seen(near, at_half_a_metre, focus_1_m), seen(near, at_1_m, relaxed), seen(near, far, focus_far),
             seen(toric, at_1_m, focus_1_m), seen(sphere, at_1_m, focus_1_m), seen(other, at_1_m, focus_1_m)})["cases"],
      0);
}

TEST(Sin2Checks, SamplingsOfThePupil) {
  // √(2/3) = 0.816497, 1, and √(5/4) = 1.118034 for four rings.
  const std::vector<StudyCase> cases = {
      study_case(sin2_radial, toric_eye, {{polar_rms, 0.82}, {weighted_rms, 0.99}, {rings_rms, 1.12}}),
      study_case(power_matrix, toric_eye, {{polar_rms, 0.81}, {weighted_rms, 1.005}, {rings_rms, 1.115}}),
      study_case(power_matrix, round_eye, {}),  // in perfect focus: no ratio
      study_case(metalstigmatism, toric_eye, {{polar_rms, 2.0}, {weighted_rms, 2.0}, {rings_rms, 2.0}})};
  EXPECT_NEAR(value_of("polar_rms_max_deviation", cases), 0.8164965809277260 - 0.81, rounding);
  EXPECT_NEAR(value_of("polar_weighted_rms_max_deviation", cases), 0.01, rounding);
  EXPECT_NEAR(value_of("rings_rms_max_deviation", cases), 1.118033988749895 - 1.115, rounding);
  for (const char* name : {"polar_rms_max_deviation", "polar_weighted_rms_max_deviation", "rings_rms_max_deviation"})
    EXPECT_EQ(check(name, cases)["cases"], 2) << name;
}

TEST(Sin2Checks, MutantsAreWrongByTheirLargestNumber) {
  const std::vector<StudyCase> cases = {
      study_case(sin2_radial, toric_eye,
                 {{mutant_repaired_as_sin2, 0.1}, {mutant_wrong_coefficient, 0.2}, {mutant_sin2_as_matrix, 0.3}}),
      study_case(sin2_radial, round_eye,
                 {{mutant_repaired_as_sin2, 0.0}, {mutant_wrong_coefficient, 0.5}, {mutant_sin2_as_matrix, 0.0}}),
      study_case(power_matrix, toric_eye, {{mutant_mirrored_axis, 0.4}})};
  const Json checks = to_json(study_checks(sin2_spec(), cases));
  EXPECT_EQ(checks["mutant_repaired_as_sin2"]["value"], 0.1);
  EXPECT_EQ(checks["mutant_wrong_coefficient"]["value"], 0.5);
  EXPECT_EQ(checks["mutant_sin2_as_matrix"]["value"], 0.3);
  EXPECT_EQ(checks["mutant_mirrored_axis"]["value"], 0.4);
  EXPECT_EQ(checks["mutant_mirrored_axis"]["cases"], 1);
}

}  // namespace
}  // namespace sturm
