#include "compare/studies/bench/evaluation.h"

#include <algorithm>

#include "compare/studies/bench/requirements.h"

namespace sturm {

namespace {

Count count(std::uint64_t number) {
  return static_cast<std::int64_t>(number);
}

BenchPoint point_of(const MeasuredSetting& setting, const PictureErrors& noise_floor) {
  const auto [fastest, slowest] =
      std::minmax_element(setting.rounds.begin(), setting.rounds.end(),
                          [](const BenchSample& a, const BenchSample& b) { return a.seconds < b.seconds; });
  const double seconds = median_seconds(setting), samples = mean_samples(setting);
  BenchPoint point{.samples_per_pixel = count(setting.samples_per_pixel),
                   .setting = setting.label,
                   .samples = samples,
                   .seconds = {.median = seconds, .shortest = fastest->seconds, .longest = slowest->seconds},
                   .samples_per_second = samples / seconds};
  for (const ErrorKind& kind : error_kinds) {
    const ErrorEstimate e = estimate(setting, noise_floor, kind);
    const Number cost =
        e.value ? Number(error_seconds({samples, seconds, *e.value, e.standard_error}, kind)) : std::nullopt;
    point.errors[std::string(kind.name)] = {
        .value = e.value, .standard_error = e.standard_error, .raw = e.raw, .status = e.status, .error_seconds = cost};
  }
  return point;
}

std::vector<std::string> methods_in(const MeasuredView& view) {
  std::vector<std::string> ids;
  for (const MeasuredSetting& setting : view.settings)
    if (ids.empty() || ids.back() != setting.method) ids.push_back(setting.method);
  return ids;
}

BenchMethodResult method_result(const MeasuredView& view, const BenchMethod& method,
                                const std::vector<ErrorLevel>& levels) {
  BenchMethodResult result{.id = method.id, .title = method.title, .biased = method.denoised};
  for (const MeasuredSetting& setting : view.settings)
    if (setting.method == method.id) result.points.push_back(point_of(setting, view.noise_floor));
  for (const ErrorKind& kind : error_kinds) {
    const auto law = fit_power_law(curve_of(view, method.id, kind).points);
    result.slopes[std::string(kind.name)] =
        law ? std::optional(BenchSlope{law->slope, law->standard_error}) : std::nullopt;
  }
  for (const ErrorLevel& level : levels) {
    const TimeToReach time = time_to_reach(curve_of(view, method.id, error_kind(level.error)).points, level.level);
    result.times.push_back({level.error, level.level, time.seconds, time.reach});
  }
  return result;
}

/// The settings of all methods that none beats in one error, by rising seconds.
std::vector<BenchFrontPoint> front_of(const MeasuredView& view, const std::vector<std::string>& methods,
                                      const ErrorKind& kind) {
  std::vector<CostPoint> points;
  std::vector<BenchFrontPoint> all, front;
  for (const std::string& method : methods) {
    const MethodCurve curve = curve_of(view, method, kind);
    points.insert(points.end(), curve.points.begin(), curve.points.end());
    for (std::size_t i = 0; i < curve.points.size(); ++i)
      all.push_back(
          {method, count(curve.samples_per_pixel[i]), curve.labels[i], curve.points[i].seconds, curve.points[i].error});
  }
  for (const std::size_t i : pareto_front(points)) front.push_back(all[i]);
  return front;
}

std::optional<BenchBest> best_of(const MethodCurve& curve, const MethodCurve& baseline) {
  const auto best = at_its_best(curve, baseline);
  if (!best) return std::nullopt;
  const std::size_t i = best->index;
  return BenchBest{.value = curve.points[i].error,
                   .seconds = curve.points[i].seconds,
                   .samples_per_pixel = count(curve.samples_per_pixel[i]),
                   .setting = curve.labels[i],
                   .baseline_seconds = best->baseline.seconds,
                   .baseline_status = best->baseline.reach,
                   .times_faster = best->times_faster};
}

/// Crossovers of the method number `i` with those after it, and its ratios to the first.
void add_comparisons(const MeasuredView& view, const std::vector<std::string>& used, std::size_t i,
                     const ErrorKind& kind, BenchViewResult& result) {
  const std::string name(kind.name);
  const MethodCurve curve = curve_of(view, used[i], kind);
  for (std::size_t j = i + 1; j < used.size(); ++j)
    for (const Crossover& c : crossovers(curve.points, curve_of(view, used[j], kind).points))
      result.crossovers.push_back({name, {used[i], used[j]}, c.seconds, c.error, c.a_ahead_after ? used[i] : used[j]});
  if (i == 0) return;
  const MethodCurve baseline = curve_of(view, used[0], kind);
  result.ratios.push_back({.error = name,
                           .method = used[i],
                           .baseline = used[0],
                           .error_ratio = error_ratio(curve, baseline),
                           .time_ratio = time_ratio(curve, baseline),
                           .cost_ratio = cost_ratio(curve, baseline, kind),
                           .at_its_best = best_of(curve, baseline)});
}

}  // namespace

BenchViewResult evaluated(const MeasuredView& view, const std::vector<BenchMethod>& methods,
                          const std::vector<ErrorLevel>& levels) {
  std::vector<std::string> used = methods_in(view);
  BenchViewResult result;
  for (const BenchMethod& method : methods)
    if (std::find(used.begin(), used.end(), method.id) != used.end())
      result.methods.push_back(method_result(view, method, levels));
  for (const BenchMethod& method : methods)
    if (method.denoised) std::erase(used, method.id);
  for (const ErrorKind& kind : error_kinds) {
    result.pareto[std::string(kind.name)] = front_of(view, used, kind);
    for (std::size_t i = 0; i < used.size(); ++i) add_comparisons(view, used, i, kind, result);
  }
  return result;
}

std::vector<BenchRequirementResult> evaluated(const std::vector<BenchRequirement>& requirements,
                                              const std::vector<MeasuredView>& views) {
  std::vector<BenchRequirementResult> results;
  for (const BenchRequirement& r : requirements)
    for (const MeasuredView& view : views) {
      if (std::find(r.views.begin(), r.views.end(), view.id) == r.views.end()) continue;
      const StatisticValue found = statistic_of(r, view);
      results.push_back({.id = r.id,
                         .title = r.title,
                         .reason = r.reason,
                         .statistic = name_of(r.statistic),
                         .error = r.error,
                         .method = r.method,
                         .baseline = r.baseline.empty() ? std::nullopt : std::optional(r.baseline),
                         .view = view.id,
                         .at_least = r.at_least,
                         .at_most = r.at_most,
                         .value = found.value,
                         .standard_error = found.standard_error,
                         .note = found.note,
                         .passed = keeps_bounds(r, found.value)});
    }
  return results;
}

BenchVerdict bench_verdict(const std::vector<BenchRequirementResult>& requirements) {
  const auto failed = std::count_if(requirements.begin(), requirements.end(),
                                    [](const BenchRequirementResult& r) { return !r.passed; });
  std::string sentence = "No requirements.";
  if (!requirements.empty())
    sentence = failed == 0 ? "All " + std::to_string(requirements.size()) + " requirements hold."
                           : std::to_string(failed) + " of " + std::to_string(requirements.size()) +
                                 " requirements do not hold.";
  return {failed == 0, sentence};
}

}  // namespace sturm
