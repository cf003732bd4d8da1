#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compare/studies/sin2/sin2_study_cases.h"
#include "compare/studies/sin2/summary.h"

namespace sturm {
namespace {

using namespace testing;
using enum StudyQuantity;
using enum RayModel;

/// The row of a table for one model (and view; null: the worst view of each eye).
Json row_of_population(const std::vector<StudyCase>& cases, const char* model, const Json& accommodation,
                       const Json& distance_m) {
  for (const Json& row : to_json(population_table(sin2_spec(), cases)))
    if (row["ray_model"] == model && row["accommodation"] == accommodation && row["distance_m"] == distance_m)
      return row;
  return nullptr;
}

StudyCase real_eye(double error, std::size_t eye = first_real_eye) {
  return study_case(sin2_radial, eye, {{error_D, error}, {error_arcmin, 10.0 * error}, {error_percent, 100.0 * error}});
}

TEST(Sin2Population, RanksByHand) {
  // Errors 0.1 … 1.0 in any order: at least half of them do not exceed 0.5, nine in ten not 0.9; above a quarter
  // dioptre are eight.
  std::vector<StudyCase> cases;
  for (const int tenths : {7, 1, 9, 3, 10, 2, 8, 5, 4, 6}) cases.push_back(real_eye(0.1 * tenths));
  const Json row = row_of_population(cases, "sin2_radial", "relaxed", 1.0);
  EXPECT_EQ(row["eyes"], 10);
  EXPECT_EQ(row["noticeable"], 8);
  EXPECT_EQ(row["pole"], 0);
  EXPECT_DOUBLE_EQ(row["error_D"]["median"], 0.5);
  EXPECT_DOUBLE_EQ(row["error_D"]["p90"], 0.9);
  EXPECT_DOUBLE_EQ(row["error_D"]["max"], 1.0);
  EXPECT_DOUBLE_EQ(row["error_arcmin"]["p90"], 9.0);
  EXPECT_DOUBLE_EQ(row["error_percent"]["median"], 50.0);
  // Of eleven the sixth is the median, and the tenth the first that nine in ten do not exceed.
  cases.push_back(real_eye(1.1));
  EXPECT_DOUBLE_EQ(row_of_population(cases, "sin2_radial", "relaxed", 1.0)["error_D"]["median"], 0.6);
  EXPECT_DOUBLE_EQ(row_of_population(cases, "sin2_radial", "relaxed", 1.0)["error_D"]["p90"], 1.0);
}

TEST(Sin2Population, AQuarterDioptreItselfIsNotNoticed) {
  EXPECT_EQ(row_of_population({real_eye(0.25)}, "sin2_radial", "relaxed", 1.0)["noticeable"], 0);
  EXPECT_EQ(row_of_population({real_eye(0.2500001)}, "sin2_radial", "relaxed", 1.0)["noticeable"], 1);
}

TEST(Sin2Population, HoldsRealEyesThroughTheReferencePupilAlone) {
  StudyCase of_grid = real_eye(9.0, same_toric_eye), other_pupil = real_eye(9.0), undefined = real_eye(9.0);
  other_pupil.pupil = 0;
  undefined.status = StudyStatus::undefined;
  const Json row = row_of_population({of_grid, other_pupil, undefined, real_eye(0.3)}, "sin2_radial", "relaxed", 1.0);
  EXPECT_EQ(row["eyes"], 1);
  EXPECT_EQ(row["error_D"]["max"], 0.3);
  EXPECT_TRUE(population_table(sin2_spec(), {of_grid, other_pupil, undefined}).empty());
}

TEST(Sin2Population, OneRowPerViewAndOneForTheWorstViewOfEachEye) {
  const StudyCase pole = study_case(metalstigmatism, first_real_eye, {}, StudyStatus::pole);
  StudyCase printed = real_eye(0.6);
  printed.model = metalstigmatism;
  const std::vector<StudyCase> cases = {real_eye(0.1), seen(real_eye(0.4), far, focus_1_m),
                                        seen(real_eye(0.2), at_half_a_metre, focus_1_m), real_eye(0.3, second_real_eye),
                                        // A pole is worse than any error, whichever comes first.
                                        printed, seen(pole, far, focus_1_m), seen(printed, at_half_a_metre, focus_1_m)};
  EXPECT_EQ(row_of_population(cases, "sin2_radial", "focus 1 m", "inf")["error_D"]["max"], 0.4);
  EXPECT_EQ(row_of_population(cases, "sin2_radial", "focus 1 m", 0.5)["error_D"]["max"], 0.2);
  EXPECT_EQ(row_of_population(cases, "sin2_radial", "relaxed", 1.0)["eyes"], 2);
  const Json worst = row_of_population(cases, "sin2_radial", nullptr, nullptr);
  EXPECT_EQ(worst["eyes"], 2);
  EXPECT_EQ(worst["error_D"]["median"], 0.3);
  EXPECT_EQ(worst["error_D"]["max"], 0.4);
  EXPECT_EQ(worst["noticeable"], 2);
  const Json as_printed = row_of_population(cases, "metalstigmatism", nullptr, nullptr);
  EXPECT_EQ(as_printed["eyes"], 1);
  EXPECT_EQ(as_printed["pole"], 1);
  EXPECT_TRUE(as_printed["error_D"]["max"].is_null());
  EXPECT_EQ(row_of_population(cases, "metalstigmatism", "focus 1 m", "inf")["pole"], 1);
}

TEST(Sin2Models, CountAndName) {
  const std::vector<StudyCase> cases = {
      study_case(metalstigmatism, round_eye,
                 {{rays, 100.0}, {rays_dropped, 3.0}, {rays_negative_focus, 40.0}, {error_D, 1.5}}),
      study_case(metalstigmatism, toric_eye, {{rays, 100.0}, {rays_dropped, 100.0}, {rays_negative_focus, 0.0}},
                 StudyStatus::pole),
      study_case(metalstigmatism, toric_eye, {}, StudyStatus::undefined),
      study_case(metalstigmatism, first_real_eye,
                 {{rays, 100.0}, {rays_dropped, 0.0}, {rays_negative_focus, 1.0}, {error_D, 2.5}}),
      study_case(sin2_radial, toric_eye, {{error_D, 7.0}})};
  const Json table = to_json(model_table(sin2_spec(), cases));
  ASSERT_EQ(table.size(), 3u);
  const Json &printed = table[0], &matrix = table[2];
  EXPECT_EQ(printed["ray_model"], "metalstigmatism");
  EXPECT_EQ(printed["cases"], 4);
  EXPECT_EQ(printed["undefined"], 1);
  EXPECT_EQ(printed["pole"], 1);
  EXPECT_EQ(printed["rays"], 300.0);
  EXPECT_EQ(printed["rays_dropped"], 103.0);
  EXPECT_EQ(printed["rays_negative_focus"], 41.0);
  EXPECT_EQ(printed["largest_error_D"], 2.5);
  EXPECT_EQ(printed["largest_error_case"], "A OD|1 m|4 mm|relaxed|metalstigmatism");
  EXPECT_EQ(table[1]["largest_error_D"], 7.0);
  EXPECT_EQ(matrix["cases"], 0);
  EXPECT_TRUE(matrix["largest_error_D"].is_null());
  EXPECT_TRUE(matrix["largest_error_case"].is_null());
}

TEST(Sin2ReferenceView, MapsRunByCylinderThenSphereAndTakeTheFirstAxis) {
  StudyCase other_pupil = study_case(sin2_radial, round_eye, {{error_D, 9.0}});
  other_pupil.pupil = 0;
  const std::vector<StudyCase> cases = {
      study_case(sin2_radial, round_eye, {{error_D, 0.0}, {true_major_arcmin, 6.0}, {major_arcmin, 5.0}}),
      study_case(sin2_radial, toric_eye, {{error_D, 0.7}, {true_major_arcmin, 8.0}, {major_arcmin, 7.0}}),
      study_case(sin2_radial, same_toric_eye, {{error_D, 0.9}}),
      study_case(sin2_radial, second_real_eye, {{error_D, 0.4}}),
      study_case(sin2_radial, first_real_eye, {{error_D, 0.2}}),
      other_pupil,
      seen(study_case(sin2_radial, round_eye, {{error_D, 9.0}}), far, relaxed),
      seen(study_case(sin2_radial, round_eye, {{error_D, 9.0}}), at_1_m, focus_1_m)};
  const Json views = to_json(reference_views(sin2_spec(), cases));
  EXPECT_EQ(views["maps"][1]["ray_model"], "sin2_radial");
  // Rows: no cylinder, −2 D; columns: 0 D, +1 D, of which no eye is there.
  EXPECT_EQ(views["maps"][1]["error_D"], (Json{{0.0, nullptr}, {0.7, nullptr}}));
  EXPECT_EQ(views["curves"][1]["points"], (Json::array({Json::array({0.0, 6.0, 5.0})})));
  EXPECT_EQ(views["cumulative"][1]["error_D"], (Json{0.2, 0.4}));
  EXPECT_EQ(views["maps"][2]["error_D"], (Json{{nullptr, nullptr}, {nullptr, nullptr}}));
  EXPECT_EQ(views["spheres_D"], (Json{0.0, 1.0}));
}

TEST(Sin2Summary, StatesItsConditions) {
  const Json summary = to_json(summarised_sin2_study(sin2_spec(), {real_eye(0.3)}, {{.id = "rose"}}));
  const Json& conditions = summary["conditions"];
  EXPECT_EQ(conditions["eyes"], 5);
  EXPECT_EQ(conditions["grid_eyes"], 3);
  EXPECT_EQ(conditions["real_eyes"], 2);
  EXPECT_EQ(conditions["distances_m"], (Json{1.0, 0.5, "inf"}));
  EXPECT_EQ(conditions["pupil_diameters_mm"], (Json{2.0, 4.0}));
  EXPECT_EQ(conditions["accommodations"], (Json{"relaxed", "focus 1 m", "focus 0.5 m", "focus inf"}));
  EXPECT_EQ(conditions["reference_distance_m"], 1.0);
  EXPECT_EQ(conditions["reference_pupil_mm"], 4.0);
  EXPECT_EQ(summary["checks"]["cases"]["value"], 1);
  EXPECT_EQ(summary["population"].size(), 2u);
  EXPECT_EQ(summary["gallery"][0]["id"], "rose");
}

}  // namespace
}  // namespace sturm
