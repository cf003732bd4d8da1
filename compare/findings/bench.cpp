#include "compare/findings/bench.h"

#include <array>
#include <nlohmann/json.hpp>

#include "compare/studies/bench/curve.h"
#include "compare/studies/bench/measured_view.h"
#include "io/files/formatted_text.h"
#include "io/json/stored.h"

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
  Measurement at(const std::string& quantity, const Json& json, const std::string& value,
                 const std::string& error) const {
    return measurement(quantity, number_at(json, value), number_at(json, error));
  }
};

/// A setting whose cost and error can be put on logarithmic axes.
std::optional<CostPoint> point_on_curve(const Json& point, const std::string& error) {
  const auto samples = number_at(point, "samples"), value = number_at(point, "errors/" + error + "/value");
  if (!samples || !value || !(*samples > 0.0) || !(*value > 0.0)) return std::nullopt;
  return CostPoint{*samples, 1.0, *value, number_at(point, "errors/" + error + "/standard_error")};
}

/// Slope of log error against log samples between the last two settings: whether more samples still help.
Measurement last_slope(const Json& points, const std::string& error, const Method& method) {
  const std::string quantity = "last_slope/" + error;
  const Measurement none = method.measurement(quantity, std::nullopt);
  if (points.size() < 2) return none;
  const auto before = point_on_curve(points[points.size() - 2], error), last = point_on_curve(points.back(), error);
  if (!before || !last) return none;
  const auto law = fit_power_law(std::array{*before, *last});
  return law ? method.measurement(quantity, law->slope, law->standard_error) : none;
}

void add_method(const Json& json, const Method& method, Measurements& out) {
  for (const ErrorKind& kind : error_kinds) {
    const std::string error(kind.name), slope = "slopes/" + error;
    out.push_back(method.at("slope/" + error, json, slope + "/slope", slope + "/standard_error"));
    if (const Json& points = array_at(json, "points"); !points.empty()) {
      const Json& last = value_at(points.back(), "errors/" + error);
      out.push_back(method.at("error/" + error, last, "value", "standard_error"));
      out.push_back(last_slope(points, error, method));
    }
  }
  for (const Json& time : array_at(json, "times"))
    if (const auto level = number_at(time, "level"))
      out.push_back(method.measurement("seconds/" + text_at(time, "error") + "/" + plain_number(*level),
                                       number_at(time, "seconds")));
}

void add_ratio(const Json& ratio, const Method& method, Measurements& out) {
  const std::string error = "/" + text_at(ratio, "error");
  for (const char* kind : {"error_ratio", "time_ratio", "cost_ratio"})
    out.push_back(method.at(kind + error, value_at(ratio, kind), "value", "standard_error"));
  out.push_back(method.measurement("times_faster" + error, number_at(ratio, "at_its_best/times_faster")));
}

Measurement broken_requirements(const Json& requirements) {
  Measurement broken{.section = "bench",
                     .quantity = "requirements that do not hold",
                     .value = 0.0,
                     .cases = requirements.size(),
                     .statistic = "bench/broken_requirements"};
  for (const Json& r : requirements)
    if (!boolean_at(r, "passed").value_or(false)) {
      *broken.value += 1.0;
      broken.worst_case = text_at(r, "id") + ", " + text_at(r, "view");
    }
  return broken;
}

}  // namespace

void measure_bench(const Json& report, Measurements& out) {
  for (const Json& view : array_at(report, "bench/views")) {
    const std::string id = text_at(view, "id");
    for (const Json& method : array_at(view, "methods"))
      if (!boolean_at(method, "biased").value_or(false)) add_method(method, {id, text_at(method, "id")}, out);
    for (const Json& ratio : array_at(view, "ratios")) add_ratio(ratio, {id, text_at(ratio, "method")}, out);
  }
  if (value_at(report, "bench").is_object()) out.push_back(broken_requirements(array_at(report, "bench/requirements")));
}

}  // namespace sturm
