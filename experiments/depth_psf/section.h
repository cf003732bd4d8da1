#pragma once
#include "experiments/run/section_run.h"

namespace sturm {

/// The section "depth_psf_study": a step for each pupil of the map, each table of eyes, and the slanted surface.
std::unique_ptr<SectionRun> prepared_depth_psf_study(const ExperimentSpec& spec, const RunOptions& options);

}  // namespace sturm
