#pragma once
#include "experiments/run/section_run.h"

namespace sturm {

/// The section "sampling_study": one step for each configuration.
std::unique_ptr<SectionRun> prepared_sampling_study(const ExperimentSpec& spec, const RunOptions& options);

}  // namespace sturm
