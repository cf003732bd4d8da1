#pragma once
#include <span>

#include "experiments/run/section_run.h"

namespace sturm {

/// All sections that an experiment can ask for, in the order in which they run. A further study is a further line
/// there.
std::span<const ExperimentSection> experiment_sections();

}  // namespace sturm
