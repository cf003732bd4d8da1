#pragma once
#include "experiments/run/section_run.h"

namespace sturm {

/// The sections "ellipses" and, from its findings, "sin2".
std::unique_ptr<SectionRun> prepared_ellipses(const ExperimentSpec& spec, const RunOptions& options);

}  // namespace sturm
