#pragma once
#include "compare/findings/measurement.h"
#include "io/json/json.h"

namespace sturm {

/// Section "bench": run time against error. All its numbers are statistics by themselves; methods whose filtered
/// picture was measured have none. For each view, method and error: `bench/VIEW/METHOD/slope/ERROR`, `…/error/ERROR`
/// (at the last setting), `…/last_slope/ERROR`, and against the view's first method `…/error_ratio/ERROR`,
/// `…/time_ratio/ERROR`, `…/cost_ratio/ERROR` and `…/times_faster/ERROR` (at the method's least error). For each level
/// `bench/VIEW/METHOD/seconds/ERROR/LEVEL`. `bench/broken_requirements`: how many of the benchmark's own requirements
/// do not hold.
void measure_bench(const Json& report, Measurements& out);

}  // namespace sturm
