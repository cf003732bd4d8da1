#pragma once
#include <string>

#include "experiments/run/run_options.h"
#include "io/specs/experiment/bench_spec.h"

namespace sturm {

struct BenchOutcome {
  bool passed = false;
  std::string text;  ///< tables and verdict
  std::filesystem::path report_html;
};

/// Runs a benchmark: references, then rounds in which every setting of every view is rendered once, so that a slow
/// spell of the machine meets all of them alike. Writes the figures, bench.html and, last, bench.json into the folder.
/// Finished rounds are kept there for `resume`, references always. Throws InputError or RuntimeFailure.
BenchOutcome run_bench(const BenchSpec& spec, const std::string& bench_file, const RunOptions& options);

}  // namespace sturm
