#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "compare/findings/lens_study.h"
#include "compare/findings/picture_numbers.h"
#include "compare/findings/sampling_study.h"
#include "compare/findings/sin2_study.h"
#include "compare/findings/study_reports.h"
#include "compare/studies/lens/synthetic_lens_study.h"
#include "reports/sections/sections.h"

namespace sturm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Measure = void (*)(const Json&, Measurements&);

/// Adds what a section lists in the table of cases.
void add_rows(Measure measure, const Json& report, Measurements& rows) {
  Measurements all;
  measure(report, all);
  for (const Measurement& m : all)
    if (m.listed_as) rows.push_back(m);
}

std::vector<CaseStatus> states(const Measurements& rows) {
  std::vector<CaseStatus> result;
  for (const Measurement& m : rows) result.push_back(*m.listed_as);
  return result;
}

TEST(ReportCases, APredictionIsHeldAgainstThePathTracersNoise) {
  Measurements cases;
  Json report = testing::agreement_report(0.97, 4e-4);
  add_rows(measure_pictures, report, cases);
  report["agreement"][0]["predictions"][0]["parts"][0]["rmse_display"]["value"] = 0.009;
  add_rows(measure_pictures, report, cases);
  report["agreement"][0]["noise_floor"] = Json::object();
  add_rows(measure_pictures, report, cases);
  EXPECT_THAT(states(cases), ElementsAre(CaseStatus::Differs, CaseStatus::Agrees, CaseStatus::NoResult));
  EXPECT_NEAR(*cases[0].value, 2.0, 1e-12);  // 0.02 over a floor of 0.01
  EXPECT_EQ(cases[0].model, "layered");
}

TEST(ReportCases, ABiasIsToldFromNoiseAtTheLevelOfAllTogether) {
  Measurements cases;
  // Eight pictures make 28 pairs: t with 27 degrees of freedom. Three cases at 1 % together are 0.33 % each, two-sided:
  // t = 3.22.
  add_rows(measure_sampling_study, testing::sampling_report(1e-5, 3.0, 0.1), cases);
  EXPECT_THAT(states(cases), ElementsAre(CaseStatus::Agrees, CaseStatus::Differs, CaseStatus::Agrees));
  EXPECT_NEAR(*cases[1].value, 0.04, 1e-12);  // √4e-4 over 0.5
  EXPECT_LT(*cases[2].z, 3.0);                // Student's tails are heavier
  cases.clear();
  add_rows(measure_sampling_study, testing::sampling_report(-1e-5, 3.5, 0.1), cases);
  EXPECT_EQ(*cases[2].listed_as, CaseStatus::Differs);
  EXPECT_LT(*cases[2].value, 0.0);  // a negative estimate of a square stays visible
}

TEST(ReportCases, ChecksNameTheirWorstCaseAndPointSpreadsTheirNoise) {
  Measurements cases;
  add_rows(measure_sin2_study, testing::sin2_report(3e-15, 0.0044), cases);
  ASSERT_EQ(cases.size(), 2u);  // theory against itself is no case
  EXPECT_EQ(cases[0].subject, "matrix_vs_theory_max");
  EXPECT_EQ(cases[0].model, "power_matrix");
  EXPECT_THAT(cases[0].quantity, HasSubstr("A|1 m|4 mm|relaxed|power_matrix"));
  EXPECT_EQ(*cases[0].listed_as, CaseStatus::Measured);
  EXPECT_EQ(*cases[1].listed_as, CaseStatus::Agrees);
  cases.clear();
  add_rows(measure_sin2_study, testing::sin2_report(3e-15, 0.4), cases);
  EXPECT_EQ(*cases[1].listed_as, CaseStatus::Differs);
}

TEST(ReportCases, SpectaclesHaveARowPerLensAndMethod) {
  Json study = {
      {"lenses", {{{"id", "A"}}, {{"id", "B"}}}},
      {"views",
       {test::study_view("A", 0.0, 0.01), test::study_view("A", 20.0, 0.3), test::study_view("B", 20.0, 0.0, false)}}};
  study["views"][1]["pupils"][1]["ray_transfer"] = nullptr;  // rays lost
  Measurements cases;
  add_rows(measure_lens_study, {{"lens_study", study}}, cases);
  ASSERT_EQ(cases.size(), 6u);
  EXPECT_THAT(states(cases), ElementsAre(CaseStatus::Agrees, CaseStatus::Differs, CaseStatus::Differs,
                                         CaseStatus::Agrees, CaseStatus::NoResult, CaseStatus::Differs));
  EXPECT_EQ(cases[0].model, "ray_transfer");
  EXPECT_DOUBLE_EQ(*cases[0].value, 0.036);  // 1e-3 D/mm² at 6 mm, straight ahead
  EXPECT_THAT(cases[0].quantity,
              HasSubstr("(0°|0.5 m, pupil 6 mm); above 0.05 D in 0 of 3 views and pupils; none in 1"));
  EXPECT_EQ(cases[1].model, "published");
  EXPECT_EQ(*cases[1].value, 0.3);
  EXPECT_THAT(cases[1].quantity, HasSubstr("(20° 0°|0.5 m, pupil 1 mm); above 0.05 D in 2 of 4 views and pupils"));
  EXPECT_EQ(cases[4].subject, "B");
  EXPECT_THAT(cases[4].quantity, HasSubstr("none in 2"));
}

TEST(ReportCases, TheCaseThatDecidedAFailedGateComesFirst) {
  const auto first_row = [](Json report, const char* statistic, const char* worst) {
    report["gates"] = {{{"id", "g"}, {"passed", false}, {"statistic", statistic}, {"worst_case", worst}}};
    const std::string page = case_section(report).markup();
    const std::size_t row = page.find("<tr", page.find("<tbody>"));
    return page.substr(row, page.find("</tr>", row) - row);
  };
  const std::string prediction =
      first_row(testing::agreement_report(0.9, 4e-4), "agreement_ssim_display_min/layered", "box");
  EXPECT_THAT(prediction, HasSubstr("data-status=\"failed\""));
  EXPECT_THAT(first_row(testing::agreement_report(0.9, 4e-4), "agreement_ssim_display_min/multipass", "box"),
              HasSubstr("data-status=\"differs\""));  // a gate about another prediction
  const std::string sampling = first_row(testing::sampling_report(1e-5, 9.0, 0.1), "sampling_unbiased_max_z",
                                         "lens|uniform_polar_weighted|halton");
  EXPECT_THAT(sampling, HasSubstr("data-status=\"failed\""));
  EXPECT_THAT(sampling, HasSubstr("uniform_polar_weighted"));
  const std::string check =
      first_row(testing::sin2_report(1.0, 0.4), "sin2_study/matrix_vs_theory_max", "A|1 m|4 mm|relaxed|power_matrix");
  EXPECT_THAT(check, HasSubstr("data-status=\"failed\""));
  EXPECT_THAT(check, HasSubstr("matrix_vs_theory_max"));
  const std::string spread =
      first_row(testing::sin2_report(1e-15, 0.4), "sin2_study/gallery_repaired_over_noise_max", "circle");
  EXPECT_THAT(spread, HasSubstr("data-status=\"failed\""));
  EXPECT_THAT(spread, HasSubstr("repaired"));
  const Json lenses = {{"lens_study",
                        {{"lenses", {{{"id", "A"}}, {{"id", "A2"}}}},
                         {"views", {test::study_view("A", 20.0, 0.3), test::study_view("A2", 0.0, 0.3)}}}}};
  const std::string lens = first_row(lenses, "lens_order_max_deviation", "A2|0°|0.5 m");
  EXPECT_THAT(lens, HasSubstr("data-status=\"failed\""));
  EXPECT_THAT(lens, HasSubstr("A2"));
  EXPECT_THAT(lens, HasSubstr("ray_transfer"));
  EXPECT_THAT(first_row(lenses, "lens_published_revolution_max_D", "A|20° 0°|0.5 m"), HasSubstr("published"));
}

}  // namespace
}  // namespace sturm
