#pragma once
#include "experiments/run/section_run.h"

namespace sturm {

/// The section "toy_study": one step.
std::unique_ptr<SectionRun> prepared_toy_study(const ExperimentSpec& spec, const RunOptions& options);

}  // namespace sturm
