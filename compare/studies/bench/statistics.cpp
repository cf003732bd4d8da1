#include "compare/studies/bench/statistics.h"

#include <array>
#include <nlohmann/json.hpp>

#include "compare/studies/bench/curve.h"
#include "compare/studies/bench/measured_view.h"
#include "io/files/formatted_text.h"
#include "io/json/stored.h"

namespace sturm {

namespace {

Statistic statistic(const Json& at, const std::string& value, const std::string& standard_error,
                    const std::string& name) {
  return {number_at(at, value), number_at(at, standard_error), 1, name};
}

/// "bench/VIEW/METHOD/".
std::string prefix_of(const std::string& view, const std::string& method) {
  return "bench/" + view + "/" + method + "/";
}

/// A setting whose cost and error can be put on logarithmic axes.
std::optional<CostPoint> point_on_curve(const Json& point, const std::string& error) {
  const auto samples = number_at(point, "samples"), value = number_at(point, "errors/" + error + "/value");
  if (!samples || !value || !(*samples > 0.0) || !(*value > 0.0)) return std::nullopt;
  return CostPoint{*samples, 1.0, *value, number_at(point, "errors/" + error + "/standard_error")};
}

/// Slope of log error against log samples between the last two settings: whether more samples still help.
Statistic last_slope(const Json& points, const std::string& error, const std::string& name) {
  Statistic none{std::nullopt, std::nullopt, 1, name};
  if (points.size() < 2) return none;
  const auto before = point_on_curve(points[points.size() - 2], error), last = point_on_curve(points.back(), error);
  if (!before || !last) return none;
  const auto law = fit_power_law(std::array{*before, *last});
  return law ? Statistic{law->slope, law->standard_error, 1, name} : none;
}

void add_method(const Json& method, const std::string& view, Statistics& out) {
  const std::string prefix = prefix_of(view, text_at(method, "id")), name = view + ", " + text_at(method, "id");
  for (const ErrorKind& kind : error_kinds) {
    const std::string error(kind.name), slope = "slopes/" + error;
    out[prefix + "slope/" + error] = statistic(method, slope + "/slope", slope + "/standard_error", name);
    if (const Json& points = array_at(method, "points"); !points.empty()) {
      const Json& last = value_at(points.back(), "errors/" + error);
      out[prefix + "error/" + error] = statistic(last, "value", "standard_error", name);
      out[prefix + "last_slope/" + error] = last_slope(points, error, name);
    }
  }
  for (const Json& time : array_at(method, "times")) {
    const auto level = number_at(time, "level");
    if (level)
      out[prefix + "seconds/" + text_at(time, "error") + "/" + plain_number(*level)] = {number_at(time, "seconds"),
                                                                                        std::nullopt, 1, name};
  }
}

}  // namespace

void add_bench_statistics(const Json& report, Statistics& out) {
  for (const Json& view : array_at(report, "bench/views")) {
    const std::string id = text_at(view, "id");
    for (const Json& method : array_at(view, "methods"))
      if (!boolean_at(method, "biased").value_or(false)) add_method(method, id, out);
    for (const Json& ratio : array_at(view, "ratios")) {
      const std::string method = text_at(ratio, "method"), prefix = prefix_of(id, method),
                        error = "/" + text_at(ratio, "error");
      const std::string name = id + ", " + method;
      for (const char* kind : {"error_ratio", "time_ratio", "cost_ratio"})
        out[prefix + kind + error] = statistic(value_at(ratio, kind), "value", "standard_error", name);
      out[prefix + "times_faster" + error] = {number_at(ratio, "at_its_best/times_faster"), std::nullopt, 1, name};
    }
  }
  const Json& requirements = array_at(report, "bench/requirements");
  Statistic broken{0.0, std::nullopt, requirements.size(), ""};
  for (const Json& r : requirements)
    if (!boolean_at(r, "passed").value_or(false)) {
      *broken.value += 1.0;
      broken.worst_case = text_at(r, "id") + ", " + text_at(r, "view");
    }
  if (value_at(report, "bench").is_object()) out["bench/broken_requirements"] = broken;
}

}  // namespace sturm
