#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "compare/studies/bench/measured_view.h"
#include "io/files/formatted_text.h"
#include "io/json/stored.h"
#include "reports/page/bench_page.h"

namespace sturm {

namespace {

/// "1.234e-05", right-aligned in ten columns; "–" for no value. (The dash is three bytes of one column.)
std::string column(std::optional<double> value, const char* format = "%10.4g") {
  if (!value) return std::string(9, ' ') + "–";
  char text[64];
  std::snprintf(text, sizeof text, format, *value);
  return text;
}

bool is_biased(const Json& method) {
  return boolean_at(method, "biased").value_or(false);
}

std::string view_text(const Json& view) {
  std::size_t width = 8;
  for (const Json& method : array_at(view, "methods")) width = std::max(width, text_at(method, "id").size() + 2);
  std::string text = text_at(view, "id") + "\n  " + padded("method", width) +
                     "   samples    time s Msample/s       RMSE rel. MSE   trimmed   1-SSIM\n";
  for (const Json& method : array_at(view, "methods")) {
    for (const Json& point : array_at(method, "points")) {
      const auto rate = number_at(point, "samples_per_second");
      text += "  " + padded(text_at(method, "id"), width) + column(number_at(point, "samples_per_pixel"), "%10.0f") +
              column(number_at(point, "seconds/median"), "%10.3g") +
              column(rate ? std::optional(1e-6 * *rate) : rate, "%10.3g") + " ";
      for (const ErrorKind& kind : error_kinds)
        text += column(number_at(point, "errors/" + std::string(kind.name) + "/value"), "%10.3g");
      const std::string setting = text_at(point, "setting");
      text += (setting.empty() ? "" : "  " + setting) + (is_biased(method) ? "  (filtered: biased)" : "") + "\n";
    }
    const auto slope = number_at(method, "slopes/rmse/slope");
    if (slope) text += "  " + padded("", width) + "slope of RMSE" + column(slope, " %.4f");
    if (const auto error = number_at(method, "slopes/rmse/standard_error"); slope && error)
      text += column(error, " ± %.4f");
    if (slope) text += "\n";
    for (const Json& time : array_at(method, "times"))
      text += "  " + padded("", width) + text_at(time, "error") + column(number_at(time, "level"), " %g") + " in" +
              column(number_at(time, "seconds"), " %.3g s") + " (" + text_at(time, "status") + ")\n";
  }
  return text;
}

std::string requirement_text(const Json& r) {
  const auto low = number_at(r, "at_least"), high = number_at(r, "at_most"), error = number_at(r, "standard_error");
  std::string bounds;
  if (low) bounds += column(low, " >= %g");
  if (high) bounds += column(high, " <= %g");
  const std::string note = text_at(r, "note");
  return std::string(boolean_at(r, "passed").value_or(false) ? "pass  " : "FAIL  ") + padded(text_at(r, "id"), 28) +
         " " + padded(text_at(r, "view"), 14) + column(number_at(r, "value"), "%10.4g") +
         (error ? column(error, " ± %.2g") : "") + bounds + (note.empty() ? "" : " (" + note + ")") + "\n";
}

std::string machine_text(const Json& machine) {
  std::string load;
  for (const Json& average : array_at(machine, "load_at_start")) load += column(number_at(average, ""), " %.2f");
  return text_at(machine, "cpu") + "," + column(number_at(machine, "cores"), " %.0f cores,") +
         column(number_at(machine, "threads"), " %.0f threads, load at the start") +
         (load.empty() ? " unknown" : load) + "\n\n";
}

/// What a view's methods are held against: the first of them; null if there is none.
const Json* baseline_of(const Json& view) {
  const Json& methods = array_at(view, "methods");
  const auto first = std::find_if_not(methods.begin(), methods.end(), is_biased);
  return first == methods.end() ? nullptr : &*first;
}

/// The method that reaches level number `index` of a view first, biased ones left out; null if none does.
const Json* first_to_reach(const Json& view, std::size_t index) {
  const Json* first = nullptr;
  const auto seconds = [index](const Json& method) {
    return number_at(method, "times/" + std::to_string(index) + "/seconds");
  };
  for (const Json& method : array_at(view, "methods"))
    if (!is_biased(method) && seconds(method) && (!first || *seconds(method) < *seconds(*first))) first = &method;
  return first;
}

/// "1 − SSIM 0.05: ellipses in 0.02 s, sobol in 0.4 s", the second being the view's first method.
std::string race_text(const Json& view, const Json& baseline, std::size_t index) {
  const std::string time = "times/" + std::to_string(index);
  const Json& level = value_at(baseline, time);
  std::string text(error_kind(text_at(level, "error")).title);
  text += column(number_at(level, "level"), " %g: ");
  const auto entry = [&](const Json& method) {
    const auto seconds = number_at(method, time + "/seconds");
    const std::string bound = text_at(method, time + "/status") == "at_once" ? " within" : " in";
    return text_at(method, "id") + (seconds ? bound + column(seconds, " %.3g s") : " never");
  };
  const Json* first = first_to_reach(view, index);
  if (!first) return text + "nobody";
  return text + entry(*first) + (first == &baseline ? "" : ", " + entry(baseline));
}

}  // namespace

Json bench_sentence(const Json& section) {
  std::string text;
  for (const Json& view : array_at(section, "views")) {
    std::string races;
    if (const Json* baseline = baseline_of(view))
      for (std::size_t i = 0; i < array_at(*baseline, "times").size(); ++i)
        races += (races.empty() ? "" : "; ") + race_text(view, *baseline, i);
    if (!races.empty()) text += (text.empty() ? "" : " ") + text_at(view, "id") + ": " + races + ".";
  }
  return text.empty() ? Json(nullptr) : Json("First to reach an error, and the view's first method. " + text);
}

std::string bench_report_text(const Json& report) {
  std::string text = machine_text(value_at(report, "machine"));
  for (const Json& view : array_at(report, "views")) text += view_text(view) + "\n";
  for (const Json& r : array_at(report, "requirements")) text += requirement_text(r);
  return text + text_at(report, "verdict/sentence") + "\n";
}

}  // namespace sturm
