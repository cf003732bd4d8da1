#pragma once
#include <optional>
#include <string>

#include "compare/studies/bench/bench_findings.h"
#include "compare/studies/bench/measured_view.h"
#include "io/specs/experiment/bench_spec.h"

namespace sturm {

StatisticValue statistic_of(const BenchRequirement& requirement, const MeasuredView& view);

/// Ratio of two methods' errors at the largest number of samples that both were set to, with its standard error.
StatisticValue error_ratio(const MethodCurve& method, const MethodCurve& baseline);

/// Time in which the method reaches the baseline's error at its last setting, over the baseline's time. Standard error:
/// that of the baseline's last error and the largest of the method's (relative), over the slope of the method's curve
/// there; none where the cheapest setting reaches it.
StatisticValue time_ratio(const MethodCurve& method, const MethodCurve& baseline);

/// Squared error × seconds of the method over that of the baseline, each at its last setting, with its standard error
/// (of the errors; the times count as exact).
StatisticValue cost_ratio(const MethodCurve& method, const MethodCurve& baseline, const ErrorKind& kind);

/// A method's least error, and where the baseline overtakes it: with more time the baseline is better than the method
/// ever was.
struct AtItsBest {
  std::size_t index = 0;               ///< of the method's point
  TimeToReach baseline;                ///< to the same error
  std::optional<double> times_faster;  ///< the baseline's seconds over the method's; none unless they are interpolated
};

/// None for a method without a value.
std::optional<AtItsBest> at_its_best(const MethodCurve& method, const MethodCurve& baseline);

/// Whether a value keeps the bounds; no value keeps none.
bool keeps_bounds(const BenchRequirement& requirement, const std::optional<double>& value);

}  // namespace sturm
