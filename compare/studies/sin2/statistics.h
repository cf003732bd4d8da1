#pragma once
#include "compare/gates/extreme_statistic.h"
#include "io/json/json.h"

namespace sturm {

/// The checks of a report's section "sin2_study" as statistics "sin2_study/NAME" (compare/findings/gate_statistics.h
/// lists them).
void add_sin2_study(const Json& report, Statistics& out);

}  // namespace sturm
