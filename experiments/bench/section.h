#pragma once
#include "experiments/run/section_run.h"

namespace sturm {

/// The section "bench": a benchmark within an experiment.
std::unique_ptr<SectionRun> prepared_bench(const ExperimentSpec& spec, const RunOptions& options);

}  // namespace sturm
