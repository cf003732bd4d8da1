#pragma once
#include "compare/gates/extreme_statistic.h"
#include "io/json/json.h"

namespace sturm {

/// The statistics of gates about a report's section "bench"; methods whose filtered picture was measured have none. For
/// each view, method and error: `bench/VIEW/METHOD/slope/ERROR`, `…/error/ERROR` (at the last setting), and against the
/// view's first method `…/error_ratio/ERROR`, `…/time_ratio/ERROR`, `…/cost_ratio/ERROR` and `…/times_faster/ERROR` (at
/// the method's least error). For each level `bench/VIEW/METHOD/seconds/ERROR/LEVEL`. `bench/broken_requirements`: how
/// many of the benchmark's own requirements do not hold.
void add_bench_statistics(const Json& report, Statistics& out);

}  // namespace sturm
