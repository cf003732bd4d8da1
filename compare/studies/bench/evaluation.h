#pragma once
#include <string>
#include <vector>

#include "compare/studies/bench/bench_findings.h"
#include "compare/studies/bench/measured_view.h"
#include "io/specs/experiment/bench_spec.h"

namespace sturm {

/// What a view's measurements say: methods (points, slopes, times to levels), Pareto fronts, crossovers and ratios; the
/// view's id, title, resolution and reference are left to the caller. Ratios are relative to the view's first method.
/// Methods whose filtered picture was measured have points, slopes and times alone: they are biased.
BenchViewResult evaluated(const MeasuredView& view, const std::vector<BenchMethod>& methods,
                          const std::vector<ErrorLevel>& levels);

/// Each requirement in each of its views.
std::vector<BenchRequirementResult> evaluated(const std::vector<BenchRequirement>& requirements,
                                              const std::vector<MeasuredView>& views);

/// Without requirements it has passed.
BenchVerdict bench_verdict(const std::vector<BenchRequirementResult>& requirements);

}  // namespace sturm
