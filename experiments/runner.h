#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "compare/findings/sections.h"
#include "experiments/run/run_options.h"
#include "experiments/sections.h"
#include "io/specs/experiment/experiment_spec.h"
#include "reports/sections/sections.h"

namespace sturm {

struct RunOutcome {
  bool passed = false;                ///< no gate failed
  std::string verdict;                ///< a sentence
  std::vector<std::string> findings;  ///< further sentences: what was measured
  std::filesystem::path report_html;
};

/// The sections that a run may have: what runs, what is measured of it, what its page shows.
struct RunTables {
  std::span<const ExperimentSection> runs = experiment_sections();
  std::span<const FindingSection> findings = finding_sections();
  std::span<const ReportSection> page = report_sections();
};

/// Runs an experiment: computes what is missing, evaluates the gates and writes ellipses.csv, junit.xml, report.html
/// and, last, report.json. Throws InputError or RuntimeFailure.
RunOutcome run_experiment(const ExperimentSpec& spec, const std::string& experiment_file, const RunOptions& options,
                          const RunTables& tables = {});

}  // namespace sturm
