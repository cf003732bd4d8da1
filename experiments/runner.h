#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/experiment_spec.h"

namespace sturm {

struct RunOptions {
  std::filesystem::path folder;  ///< where the report goes
  int threads = 0;               ///< for the provenance
  bool resume = false;
  bool quiet = false;
};

struct RunOutcome {
  bool passed = false;
  std::string verdict;                ///< a sentence
  std::vector<std::string> findings;  ///< further sentences: what was measured
  std::filesystem::path report_html;
};

/// Runs an experiment: computes what is missing, evaluates the gates and writes ellipses.csv, junit.xml, report.html and, last,
/// report.json. Throws InputError or RuntimeFailure.
RunOutcome run_experiment(const ExperimentSpec& spec, const std::string& experiment_file, const RunOptions& options);

}  // namespace sturm
