#include "compare/findings/bench.h"

#include <array>

#include "compare/studies/bench/bench_findings.h"
#include "compare/studies/bench/curve.h"
#include "compare/studies/bench/measured_view.h"
#include "io/files/formatted_text.h"

namespace sturm {

namespace {

/// One method in one view.
struct Method {
  std::string view, id;

  Measurement measurement(const std::string& quantity, const Number& value, const Number& error = std::nullopt) const {
    return {.section = "bench",
            .subject = view + ", " + id,
            .model = id,
            .quantity = quantity,
            .value = value,
            .standard_error = error,
            .statistic = "bench/" + view + "/" + id + "/" + quantity};
  }
};

/// A setting whose cost and error can be put on logarithmic axes.
std::optional<CostPoint> point_on_curve(const BenchPoint& point, const std::string& name) {
  const BenchError error = point.error(name);
  if (!point.samples || !error.value || !(*point.samples > 0.0) || !(*error.value > 0.0)) return std::nullopt;
  return CostPoint{*point.samples, 1.0, *error.value, error.standard_error};
}

/// Slope of log error against log samples between the last two settings: whether more samples still help.
Measurement last_slope(const std::vector<BenchPoint>& points, const std::string& error, const Method& method) {
  const std::string quantity = "last_slope/" + error;
  const Measurement none = method.measurement(quantity, std::nullopt);
  if (points.size() < 2) return none;
  const auto before = point_on_curve(points[points.size() - 2], error), last = point_on_curve(points.back(), error);
  if (!before || !last) return none;
  const auto law = fit_power_law(std::array{*before, *last});
  return law ? method.measurement(quantity, law->slope, law->standard_error) : none;
}

void add_method(const BenchMethodResult& result, const Method& method, Measurements& out) {
  for (const ErrorKind& kind : error_kinds) {
    const std::string error(kind.name);
    const BenchSlope slope = result.slope(error);
    out.push_back(method.measurement("slope/" + error, slope.slope, slope.standard_error));
    if (result.points.empty()) continue;
    const BenchError last = result.points.back().error(error);
    out.push_back(method.measurement("error/" + error, last.value, last.standard_error));
    out.push_back(last_slope(result.points, error, method));
  }
  for (const BenchTime& time : result.times)
    if (time.level)
      out.push_back(method.measurement("seconds/" + time.error + "/" + plain_number(*time.level), time.seconds));
}

void add_ratio(const BenchRatio& ratio, const Method& method, Measurements& out) {
  const auto add = [&](const char* kind, const StatisticValue& found) {
    out.push_back(method.measurement(kind + ("/" + ratio.error), found.value, found.standard_error));
  };
  add("error_ratio", ratio.error_ratio);
  add("time_ratio", ratio.time_ratio);
  add("cost_ratio", ratio.cost_ratio);
  out.push_back(method.measurement("times_faster/" + ratio.error,
                                   ratio.at_its_best ? ratio.at_its_best->times_faster : std::nullopt));
}

Measurement broken_requirements(const std::vector<BenchRequirementResult>& requirements) {
  Measurement broken{.section = "bench",
                     .quantity = "requirements that do not hold",
                     .value = 0.0,
                     .cases = requirements.size(),
                     .statistic = "bench/broken_requirements"};
  for (const BenchRequirementResult& r : requirements)
    if (!r.passed) {
      *broken.value += 1.0;
      broken.worst_case = r.id + ", " + r.view;
    }
  return broken;
}

}  // namespace

void measure_bench(const Json& report, Measurements& out) {
  const std::optional<BenchFindings> found = bench_findings(report);
  if (!found) return;
  for (const BenchViewResult& view : found->views) {
    for (const BenchMethodResult& method : view.methods)
      if (!method.biased) add_method(method, {view.id, method.id}, out);
    for (const BenchRatio& ratio : view.ratios) add_ratio(ratio, {view.id, ratio.method}, out);
  }
  out.push_back(broken_requirements(found->requirements));
}

}  // namespace sturm
