#pragma once
#include "experiments/run/section_run.h"

namespace sturm {

/// The section "design_study": a step for each design, and one for each design's wearers.
std::unique_ptr<SectionRun> prepared_design_study(const ExperimentSpec& spec, const RunOptions& options);

}  // namespace sturm
