#pragma once
#include "experiments/run/section_run.h"

namespace sturm {

/// The section "images": scenes path traced with each ray model and predicted once.
std::unique_ptr<SectionRun> prepared_images(const ExperimentSpec& spec, const RunOptions& options);

}  // namespace sturm
