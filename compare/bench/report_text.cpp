#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "compare/bench/measured_view.h"
#include "compare/bench/report_html.h"
#include "compare/report_json.h"

namespace sturm {

namespace {

/// "1.234e-05", right-aligned in ten columns; "–" for no value. (The dash is three bytes of one column.)
std::string column(std::optional<double> value, const char* format = "%10.4g") {
  if (!value) return std::string(9, ' ') + "–";
  char text[64];
  std::snprintf(text, sizeof text, format, *value);
  return text;
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

std::string view_text(const Json& view) {
  std::size_t width = 8;
  for (const Json& method : array_at(view, "methods")) width = std::max(width, text_at(method, "id").size() + 2);
  std::string text =
      text_at(view, "id") + "\n  " + padded("method", width) + "   samples    time s Msample/s       RMSE rel. MSE   trimmed   1-SSIM\n";
  for (const Json& method : array_at(view, "methods")) {
    for (const Json& point : array_at(method, "points")) {
      const auto rate = number_at(point, "samples_per_second");
      text += "  " + padded(text_at(method, "id"), width) + column(number_at(point, "samples_per_pixel"), "%10.0f") +
              column(number_at(point, "seconds/median"), "%10.3g") + column(rate ? std::optional(1e-6 * *rate) : rate, "%10.3g") + " ";
      for (const ErrorKind& kind : error_kinds) text += column(number_at(point, "errors/" + std::string(kind.name) + "/value"), "%10.3g");
      text += "\n";
    }
    const auto slope = number_at(method, "slopes/rmse/slope");
    if (slope) text += "  " + padded("", width) + "slope of RMSE" + column(slope, " %.4f");
    if (const auto error = number_at(method, "slopes/rmse/standard_error"); slope && error) text += column(error, " ± %.4f");
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
  return std::string(boolean_at(r, "passed").value_or(false) ? "pass  " : "FAIL  ") + padded(text_at(r, "id"), 28) + " " +
         padded(text_at(r, "view"), 14) + column(number_at(r, "value"), "%10.4g") + (error ? column(error, " ± %.2g") : "") + bounds +
         (note.empty() ? "" : " (" + note + ")") + "\n";
}

}  // namespace

std::string bench_report_text(const Json& report) {
  std::string text;
  for (const Json& view : array_at(report, "views")) text += view_text(view) + "\n";
  for (const Json& r : array_at(report, "requirements")) text += requirement_text(r);
  return text + text_at(report, "verdict/sentence") + "\n";
}

}  // namespace sturm
