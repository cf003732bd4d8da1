#pragma once
#include "experiments/run/section_run.h"

namespace sturm {

/// The section "agreement": views path traced and predicted in several ways.
std::unique_ptr<SectionRun> prepared_agreement(const ExperimentSpec& spec, const RunOptions& options);

}  // namespace sturm
