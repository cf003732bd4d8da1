#pragma once
#include "experiments/run/section_run.h"

namespace sturm {

/// The sections "images" and "agreement": views path traced by ray models and predicted.
std::unique_ptr<SectionRun> prepared_pictures(const ExperimentSpec& spec, const RunOptions& options);

}  // namespace sturm
