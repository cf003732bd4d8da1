#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/run/run_options.h"
#include "io/specs/experiment/experiment_spec.h"

namespace sturm {

struct RunOutcome {
  bool passed = false;
  std::string verdict;                ///< a sentence
  std::vector<std::string> findings;  ///< further sentences: what was measured
  std::filesystem::path report_html;
};

/// Runs an experiment: computes what is missing, evaluates the gates and writes ellipses.csv, junit.xml, report.html
/// and, last, report.json. Throws InputError or RuntimeFailure.
RunOutcome run_experiment(const ExperimentSpec& spec, const std::string& experiment_file, const RunOptions& options);

}  // namespace sturm
