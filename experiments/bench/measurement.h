#pragma once
#include <string>
#include <vector>

#include "compare/studies/bench/bench_findings.h"
#include "experiments/run/run_folder.h"
#include "io/specs/experiment/bench_spec.h"
#include "reports/plots/figure.h"

namespace sturm {

/// What a benchmark's numbers depend on.
struct BenchKeys {
  std::vector<std::string> references;  ///< `reference_key` of each view
  std::string run;                      ///< of the rounds: everything, the program and the number of threads included
};

/// Loads every scene, so what is wrong with one shows before an output folder is touched. Throws InputError.
BenchKeys bench_keys(const BenchSpec& spec, int threads);

/// Where a benchmark's measurement takes place.
struct BenchPlace {
  const RunFolder& folder;  ///< with a folder "references"; finished rounds are parts of it
  int threads;
  bool quiet;
};

/// Makes the references, or takes them from the folder, then measures in rounds in which every setting of every view is
/// rendered once, so that a slow spell of the machine meets all of them alike. Throws InputError or RuntimeFailure.
BenchFindings measured_bench(const BenchSpec& spec, const BenchKeys& keys, const BenchPlace& place);

}  // namespace sturm
