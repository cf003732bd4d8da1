#pragma once
#include "compare/gates/extreme_statistic.h"
#include "io/json/json.h"

namespace sturm {

/// The statistics of a report's section "sampling_study" (compare/findings/gate_statistics.h lists them).
void add_sampling_study(const Json& report, Statistics& out);

}  // namespace sturm
