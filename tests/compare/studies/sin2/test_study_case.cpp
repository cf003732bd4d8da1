#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compare/studies/sin2/study_case.h"

namespace sturm {
namespace {

// Stored parts of a run are read back by later versions: the numbers that stand for models are part of the format.
TEST(StudyCase, ModelsHaveTheirPlaceInTheListOfTheStudy) {
  const std::pair<RayModel, int> places[] = {
      {RayModel::metalstigmatism, 0}, {RayModel::sin2_radial, 1}, {RayModel::power_matrix, 2}};
  for (const auto& [model, place] : places) {
    StudyCase c;
    c.model = model;
    EXPECT_EQ(row_of(c).at(4), place) << name_of(model);
    EXPECT_EQ(case_of(row_of(c)).model, model);
  }
}

TEST(StudyCase, IsReadBack) {
  StudyCase c;
  c.eye = 3;
  c.distance = 2;
  c.pupil = 1;
  c.accommodation = 4;
  c.model = RayModel::sin2_radial;
  c.status = StudyStatus::pole;
  c[StudyQuantity::error_D] = 0.25;
  const StudyCase again = case_of(row_of(c));
  EXPECT_EQ(again.eye, 3u);
  EXPECT_EQ(again.distance, 2u);
  EXPECT_EQ(again.pupil, 1u);
  EXPECT_EQ(again.accommodation, 4u);
  EXPECT_EQ(again.status, StudyStatus::pole);
  EXPECT_EQ(again[StudyQuantity::error_D], 0.25);
  EXPECT_FALSE(again[StudyQuantity::rays].has_value());
}

}  // namespace
}  // namespace sturm
