#pragma once
#include "experiments/run/section_run.h"

namespace sturm {

/// The section "lens_study": one step for each lens, one for the wide field.
std::unique_ptr<SectionRun> prepared_lens_study(const ExperimentSpec& spec, const RunOptions& options);

}  // namespace sturm
