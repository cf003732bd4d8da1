#pragma once
#include "experiments/run/section_run.h"

namespace sturm {

/// The section "reference": the conoid and the closed form of sin² against independent numbers in a file.
std::unique_ptr<SectionRun> prepared_reference(const ExperimentSpec& spec, const RunOptions& options);

}  // namespace sturm
