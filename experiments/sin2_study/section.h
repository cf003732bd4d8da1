#pragma once
#include "experiments/run/section_run.h"

namespace sturm {

/// The section "sin2_study": one step for each group of eyes and each view of the gallery.
std::unique_ptr<SectionRun> prepared_sin2_study(const ExperimentSpec& spec, const RunOptions& options);

}  // namespace sturm
