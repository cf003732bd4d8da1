#include "compare/studies/bench/evaluation.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compare/studies/bench/requirements.h"
#include "io/json/values.h"

namespace sturm {

namespace {

const char* word(FloorStatus status) {
  return status == FloorStatus::Clear ? "ok" : status == FloorStatus::Near ? "near_noise_floor" : "below_noise_floor";
}

const char* word(Reach reach) {
  return reach == Reach::Interpolated ? "interpolated" : reach == Reach::AtOnce ? "at_once" : "never";
}

Json point_json(const MeasuredSetting& setting, const PictureErrors& noise_floor) {
  const auto [fastest, slowest] =
      std::minmax_element(setting.rounds.begin(), setting.rounds.end(),
                          [](const BenchSample& a, const BenchSample& b) { return a.seconds < b.seconds; });
  const double seconds = median_seconds(setting), samples = mean_samples(setting);
  Json errors;
  for (const ErrorKind& kind : error_kinds) {
    const ErrorEstimate e = estimate(setting, noise_floor, kind);
    const Json cost =
        e.value ? Json(error_seconds({samples, seconds, *e.value, e.standard_error}, kind)) : Json(nullptr);
    errors[std::string(kind.name)] = {{"value", number_or_null(e.value)},
                                      {"standard_error", number_or_null(e.standard_error)},
                                      {"raw", e.raw},
                                      {"status", word(e.status)},
                                      {"error_seconds", cost}};
  }
  return {{"samples_per_pixel", setting.samples_per_pixel},
          {"setting", setting.label},
          {"samples", samples},
          {"seconds", {{"median", seconds}, {"shortest", fastest->seconds}, {"longest", slowest->seconds}}},
          {"samples_per_second", samples / seconds},
          {"errors", std::move(errors)}};
}

std::vector<std::string> methods_in(const MeasuredView& view) {
  std::vector<std::string> ids;
  for (const MeasuredSetting& setting : view.settings)
    if (ids.empty() || ids.back() != setting.method) ids.push_back(setting.method);
  return ids;
}

Json method_json(const MeasuredView& view, const BenchMethod& method, const std::vector<ErrorLevel>& levels) {
  Json entry = {{"id", method.id},         {"title", method.title},    {"biased", method.denoised},
                {"points", Json::array()}, {"slopes", Json::object()}, {"times", Json::array()}};
  for (const MeasuredSetting& setting : view.settings)
    if (setting.method == method.id) entry["points"].push_back(point_json(setting, view.noise_floor));
  for (const ErrorKind& kind : error_kinds) {
    const auto law = fit_power_law(curve_of(view, method.id, kind).points);
    entry["slopes"][std::string(kind.name)] =
        law ? Json{{"slope", law->slope}, {"standard_error", number_or_null(law->standard_error)}} : Json(nullptr);
  }
  for (const ErrorLevel& level : levels) {
    const TimeToReach time = time_to_reach(curve_of(view, method.id, error_kind(level.error)).points, level.level);
    entry["times"].push_back({{"error", level.error},
                              {"level", level.level},
                              {"seconds", number_or_null(time.seconds)},
                              {"status", word(time.reach)}});
  }
  return entry;
}

/// The settings of all methods that none beats in one error, by rising seconds.
Json pareto_json(const MeasuredView& view, const std::vector<std::string>& methods, const ErrorKind& kind) {
  std::vector<CostPoint> points;
  Json names = Json::array(), front = Json::array();
  for (const std::string& method : methods) {
    const MethodCurve curve = curve_of(view, method, kind);
    points.insert(points.end(), curve.points.begin(), curve.points.end());
    for (std::size_t i = 0; i < curve.points.size(); ++i)
      names.push_back(
          {{"method", method}, {"samples_per_pixel", curve.samples_per_pixel[i]}, {"setting", curve.labels[i]}});
  }
  for (const std::size_t i : pareto_front(points)) {
    Json entry = names[i];
    entry["seconds"] = points[i].seconds;
    entry["value"] = points[i].error;
    front.push_back(std::move(entry));
  }
  return front;
}

Json statistic_json(const StatisticValue& s) {
  return {{"value", number_or_null(s.value)}, {"standard_error", number_or_null(s.standard_error)}, {"note", s.note}};
}

Json best_json(const MethodCurve& curve, const MethodCurve& baseline) {
  const auto best = at_its_best(curve, baseline);
  if (!best) return nullptr;
  const std::size_t i = best->index;
  return {{"value", curve.points[i].error},
          {"seconds", curve.points[i].seconds},
          {"samples_per_pixel", curve.samples_per_pixel[i]},
          {"setting", curve.labels[i]},
          {"baseline_seconds", number_or_null(best->baseline.seconds)},
          {"baseline_status", word(best->baseline.reach)},
          {"times_faster", number_or_null(best->times_faster)}};
}

}  // namespace

Json evaluated(const MeasuredView& view, const std::vector<BenchMethod>& methods,
               const std::vector<ErrorLevel>& levels) {
  std::vector<std::string> used = methods_in(view);
  Json result = {
      {"methods", Json::array()}, {"pareto", Json::object()}, {"crossovers", Json::array()}, {"ratios", Json::array()}};
  for (const BenchMethod& method : methods)
    if (std::find(used.begin(), used.end(), method.id) != used.end())
      result["methods"].push_back(method_json(view, method, levels));
  for (const BenchMethod& method : methods)
    if (method.denoised) std::erase(used, method.id);
  for (const ErrorKind& kind : error_kinds) {
    const std::string name(kind.name);
    result["pareto"][name] = pareto_json(view, used, kind);
    for (std::size_t i = 0; i < used.size(); ++i) {
      const MethodCurve curve = curve_of(view, used[i], kind);
      for (std::size_t j = i + 1; j < used.size(); ++j)
        for (const Crossover& c : crossovers(curve.points, curve_of(view, used[j], kind).points))
          result["crossovers"].push_back({{"error", name},
                                          {"methods", {used[i], used[j]}},
                                          {"seconds", c.seconds},
                                          {"value", c.error},
                                          {"better_after", c.a_ahead_after ? used[i] : used[j]}});
      if (i == 0) continue;
      const MethodCurve baseline = curve_of(view, used[0], kind);
      result["ratios"].push_back({{"error", name},
                                  {"method", used[i]},
                                  {"baseline", used[0]},
                                  {"error_ratio", statistic_json(error_ratio(curve, baseline))},
                                  {"time_ratio", statistic_json(time_ratio(curve, baseline))},
                                  {"cost_ratio", statistic_json(cost_ratio(curve, baseline, kind))},
                                  {"at_its_best", best_json(curve, baseline)}});
    }
  }
  return result;
}

Json evaluated(const std::vector<BenchRequirement>& requirements, const std::vector<MeasuredView>& views) {
  Json results = Json::array();
  for (const BenchRequirement& r : requirements)
    for (const MeasuredView& view : views) {
      if (std::find(r.views.begin(), r.views.end(), view.id) == r.views.end()) continue;
      Json entry = statistic_json(statistic_of(r, view));
      const std::optional<double> value =
          entry["value"].is_null() ? std::nullopt : std::optional(entry["value"].get<double>());
      entry.update({{"id", r.id},
                    {"title", r.title},
                    {"reason", r.reason},
                    {"statistic", name_of(r.statistic)},
                    {"error", r.error},
                    {"method", r.method},
                    {"baseline", r.baseline.empty() ? Json(nullptr) : Json(r.baseline)},
                    {"view", view.id},
                    {"at_least", number_or_null(r.at_least)},
                    {"at_most", number_or_null(r.at_most)},
                    {"passed", keeps_bounds(r, value)}});
      results.push_back(std::move(entry));
    }
  return results;
}

Json bench_verdict(const Json& requirements) {
  std::size_t failed = 0;
  for (const Json& r : requirements) failed += r.at("passed").get<bool>() ? 0 : 1;
  std::string sentence = "No requirements.";
  if (!requirements.empty())
    sentence = failed == 0 ? "All " + std::to_string(requirements.size()) + " requirements hold."
                           : std::to_string(failed) + " of " + std::to_string(requirements.size()) +
                                 " requirements do not hold.";
  return {{"passed", failed == 0}, {"sentence", sentence}};
}

Json picture_errors_json(const PictureErrors& e) {
  return {{"mse", e.mse},
          {"relative_mse", e.relative_mse},
          {"relative_mse_trimmed", e.relative_mse_trimmed},
          {"one_minus_ssim", e.one_minus_ssim}};
}

PictureErrors picture_errors_from(const Json& json) {
  return {json.at("mse").get<double>(), json.at("relative_mse").get<double>(),
          json.at("relative_mse_trimmed").get<double>(), json.at("one_minus_ssim").get<double>()};
}

}  // namespace sturm
