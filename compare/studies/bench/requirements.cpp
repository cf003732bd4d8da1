#include "compare/studies/bench/requirements.h"

#include <algorithm>
#include <cmath>

namespace sturm {

namespace {

const char* const nothing_left = "an error is lost in the noise of the reference";

/// √(Σ of the squared relative standard errors); none if one is not known.
std::optional<double> relative_error_of(const CostPoint& a, const CostPoint& b) {
  if (!a.standard_error || !b.standard_error) return std::nullopt;
  return std::hypot(*a.standard_error / a.error, *b.standard_error / b.error);
}

StatisticValue ratio(double value, const std::optional<double>& relative) {
  return {value, relative ? std::optional(value * *relative) : std::nullopt, ""};
}

}  // namespace

StatisticValue error_ratio(const MethodCurve& method, const MethodCurve& baseline) {
  const CostPoint *a = nullptr, *b = nullptr;
  std::uint64_t samples = 0;
  for (std::size_t i = 0; i < method.points.size(); ++i)
    for (std::size_t j = 0; j < baseline.points.size(); ++j)
      if (method.samples_per_pixel[i] == baseline.samples_per_pixel[j] && method.samples_per_pixel[i] > samples) {
        samples = method.samples_per_pixel[i];
        a = &method.points[i], b = &baseline.points[j];
      }
  if (!a) return {std::nullopt, std::nullopt, "no number of samples that both have an error for"};
  StatisticValue result = ratio(a->error / b->error, relative_error_of(*a, *b));
  result.note = "at " + std::to_string(samples) + " samples per pixel";
  return result;
}

StatisticValue time_ratio(const MethodCurve& method, const MethodCurve& baseline) {
  if (method.points.empty() || baseline.points.empty()) return {std::nullopt, std::nullopt, nothing_left};
  const CostPoint& goal = baseline.points.back();
  const TimeToReach reached = time_to_reach(method.points, goal.error);
  if (!reached.seconds) return {std::nullopt, std::nullopt, "the error is never reached"};
  const double value = *reached.seconds / goal.seconds;
  if (!reached.slope) return {value, std::nullopt, "at most: the cheapest setting reaches the error"};
  const auto least_certain =
      std::max_element(method.points.begin(), method.points.end(), [](const CostPoint& a, const CostPoint& b) {
        return a.standard_error.value_or(0.0) / a.error < b.standard_error.value_or(0.0) / b.error;
      });
  std::optional<double> relative = relative_error_of(*least_certain, goal);
  if (relative) *relative /= std::abs(*reached.slope);
  return ratio(value, relative);
}

StatisticValue cost_ratio(const MethodCurve& method, const MethodCurve& baseline, const ErrorKind& kind) {
  if (method.points.empty() || baseline.points.empty()) return {std::nullopt, std::nullopt, nothing_left};
  const CostPoint &a = method.points.back(), &b = baseline.points.back();
  std::optional<double> relative = relative_error_of(a, b);
  if (relative && kind.is_root) *relative *= 2.0;
  return ratio(error_seconds(a, kind) / error_seconds(b, kind), relative);
}

StatisticValue statistic_of(const BenchRequirement& requirement, const MeasuredView& view) {
  const ErrorKind& kind = error_kind(requirement.error);
  const MethodCurve method = curve_of(view, requirement.method, kind);
  const MethodCurve baseline =
      requirement.baseline.empty() ? MethodCurve{} : curve_of(view, requirement.baseline, kind);
  switch (requirement.statistic) {
    case BenchStatistic::Slope: {
      const auto law = fit_power_law(method.points);
      if (!law) return {std::nullopt, std::nullopt, "fewer than two errors above the noise of the reference"};
      return {law->slope, law->standard_error, ""};
    }
    case BenchStatistic::Error:
      if (method.points.empty()) return {std::nullopt, std::nullopt, nothing_left};
      return {method.points.back().error, method.points.back().standard_error, ""};
    case BenchStatistic::ErrorRatio:
      return error_ratio(method, baseline);
    case BenchStatistic::TimeRatio:
      return time_ratio(method, baseline);
    case BenchStatistic::CostRatio:
      return cost_ratio(method, baseline, kind);
  }
  throw std::logic_error("unknown statistic");
}

std::optional<AtItsBest> at_its_best(const MethodCurve& method, const MethodCurve& baseline) {
  if (method.points.empty()) return std::nullopt;
  const auto best = std::min_element(method.points.begin(), method.points.end(),
                                     [](const CostPoint& a, const CostPoint& b) { return a.error < b.error; });
  AtItsBest result;
  result.index = static_cast<std::size_t>(best - method.points.begin());
  result.baseline = time_to_reach(baseline.points, best->error);
  if (result.baseline.reach == Reach::Interpolated) result.times_faster = *result.baseline.seconds / best->seconds;
  return result;
}

bool keeps_bounds(const BenchRequirement& requirement, const std::optional<double>& value) {
  return value && std::isfinite(*value) && (!requirement.at_least || *value >= *requirement.at_least) &&
         (!requirement.at_most || *value <= *requirement.at_most);
}

}  // namespace sturm
