#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/findings/judged_report.h"
#include "experiments/runner.h"
#include "experiments/toy_study/toy_findings.h"
#include "experiments/toy_study/toy_page.h"
#include "experiments/toy_study/toy_section.h"
#include "experiments/toy_study/toy_spec.h"
#include "io/files/error.h"

/// The worked example of CONTRIBUTING.md, "How to add a study": the files of this folder and a line in each of three
/// tables are all that a study needs.
namespace sturm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

/// The program's table with a further line.
template <class Line>
std::vector<Line> with_line(std::span<const Line> table, const Line& line) {
  std::vector<Line> longer(table.begin(), table.end());
  longer.push_back(line);
  return longer;
}

class ToyStudy : public ::testing::Test {
 protected:
  ToyStudy() : folder_(fs::path(::testing::TempDir()) / ("sturm_toy_study_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
    const Json gate = {{"id", "toy"},
                       {"title", "Rays and formula agree"},
                       {"statistic", "toy_max_deviation"},
                       {"comparison", "at_most"},
                       {"bound", 1e-12},
                       {"reason", "rounding"}};
    std::ofstream(folder_ / "gates.json") << Json{{"format", "sturm.gates/1"}, {"gates", {gate}}};
    spec_.title = "A toy";
    spec_.gates = folder_ / "gates.json";
    spec_.resolved = std::make_shared<const Json>(
        Json{{"toy_study", {{"pupil_diameter_mm", 4.0}, {"defocus_D", {0.5, -1.0, 2.0}}}}});
  }
  ~ToyStudy() override { fs::remove_all(folder_); }

  RunOutcome run(const RunTables& tables, bool resume = false) const {
    return run_experiment(spec_, "-", {folder_ / "out", 1, resume, true}, tables);
  }
  RunTables tables() const { return {runs_, findings_, page_}; }
  Json report() const { return load_json((folder_ / "out/report.json").string()); }
  std::string page() const {
    std::ifstream file(folder_ / "out/report.html");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  // Here the study gets into the program.
  std::vector<ExperimentSection> runs_ =
      with_line(experiment_sections(), {"toy_study", "toy_sentence", nullptr, prepared_toy_study});
  std::vector<FindingSection> findings_ =
      with_line(finding_sections(), {"toy_study", measure_toy_study, toy_study_rules()});
  std::vector<ReportSection> page_ = with_line(report_sections(), {"toy_study", "Toy study", toy_study_section});

  fs::path folder_;
  ExperimentSpec spec_;
};

TEST_F(ToyStudy, RunsAndIsJudgedAndDrawn) {
  const RunOutcome outcome = run(tables());
  EXPECT_TRUE(outcome.passed) << outcome.verdict;
  EXPECT_THAT(outcome.findings, ElementsAre("The toy study traced 3 eyes."));
  const ToyFindings found = toy_findings(report()).value();
  ASSERT_EQ(found.entries.size(), 3u);
  // Half of 4 mm times 1 D: 2 mrad, which is 6.875 arcmin.
  EXPECT_NEAR(found.entries[1].traced_arcmin.value(), 6.8754935415698775, 1e-12);
  EXPECT_EQ(report()["verdict"]["toy_sentence"], "The toy study traced 3 eyes.");
  EXPECT_THAT(page(), HasSubstr("<section id=\"toy_study\">"));
  EXPECT_THAT(page(), HasSubstr("<a href=\"#toy_study\">Toy study</a>"));
}

TEST_F(ToyStudy, WithoutItsLineOfMeasuresAGateHasNoNumber) {
  EXPECT_FALSE(run({runs_, finding_sections(), page_}).passed);
  EXPECT_TRUE(report()["gates"][0]["value"].is_null());
}

TEST_F(ToyStudy, WithoutItsLineInThePageItIsNotShown) {
  EXPECT_TRUE(run({runs_, findings_, report_sections()}).passed);
  EXPECT_THAT(page(), Not(HasSubstr("toy_study\">")));
}

TEST_F(ToyStudy, AWrongNumberFailsTheGateAndIsNamed) {
  run(tables());
  Json wrong = report();
  wrong["toy_study"]["entries"][2]["traced_arcmin"] = 14.0;
  const std::vector<GateResult> results =
      evaluate_gates(read_gates(load_json(spec_.gates.string()), "gates.json"), wrong, nullptr, findings_);
  EXPECT_FALSE(results[0].has_passed());
  EXPECT_EQ(results[0].worst_case, "2 D");
}

TEST_F(ToyStudy, FindingsComeBackAsTheyWere) {
  run(tables());
  const ToyFindings found = toy_findings(report()).value();
  EXPECT_EQ(to_json(found), report()["toy_study"]);
  EXPECT_EQ(toy_findings({{"toy_study", to_json(found)}}), found);
  EXPECT_FALSE(toy_findings(Json::object()));
}

TEST_F(ToyStudy, WrongInputIsNamedBeforeAnythingIsWritten) {
  spec_.resolved =
      std::make_shared<const Json>(Json{{"toy_study", {{"pupil_diameter_mm", 0.0}, {"defocus_D", {1.0}}}}});
  try {
    run(tables());
    FAIL() << "a pupil of 0 mm was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/toy_study/pupil_diameter_mm"));
  }
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

}  // namespace
}  // namespace sturm
