#pragma once
#include "experiments/run/section_run.h"

namespace sturm {

/// The section "psfs": rendered images of point-like emitters.
std::unique_ptr<SectionRun> prepared_psfs(const ExperimentSpec& spec, const RunOptions& options);

}  // namespace sturm
