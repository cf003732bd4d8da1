#include <algorithm>
#include <cstdio>

#include "compare/studies/bench/measured_view.h"
#include "io/files/formatted_text.h"
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

std::string view_text(const BenchViewResult& view) {
  std::size_t width = 8;
  for (const BenchMethodResult& method : view.methods) width = std::max(width, method.id.size() + 2);
  std::string text = view.id + "\n  " + padded("method", width) +
                     "   samples    time s Msample/s       RMSE rel. MSE   trimmed   1-SSIM\n";
  for (const BenchMethodResult& method : view.methods) {
    for (const BenchPoint& point : method.points) {
      const Number rate = point.samples_per_second;
      text += "  " + padded(method.id, width) + column(point.samples_per_pixel, "%10.0f") +
              column(point.seconds.median, "%10.3g") + column(rate ? std::optional(1e-6 * *rate) : rate, "%10.3g") +
              " ";
      for (const ErrorKind& kind : error_kinds) text += column(point.error(kind.name).value, "%10.3g");
      text +=
          (point.setting.empty() ? "" : "  " + point.setting) + (method.biased ? "  (filtered: biased)" : "") + "\n";
    }
    const auto [slope, error] = method.slope("rmse");
    if (slope) text += "  " + padded("", width) + "slope of RMSE" + column(slope, " %.4f");
    if (slope && error) text += column(error, " ± %.4f");
    if (slope) text += "\n";
    for (const BenchTime& time : method.times)
      text += "  " + padded("", width) + time.error + column(time.level, " %g") + " in" +
              column(time.seconds, " %.3g s") + " (" + word_of(time.status) + ")\n";
  }
  return text;
}

std::string requirement_text(const BenchRequirementResult& r) {
  std::string bounds;
  if (r.at_least) bounds += column(r.at_least, " >= %g");
  if (r.at_most) bounds += column(r.at_most, " <= %g");
  return std::string(r.passed ? "pass  " : "FAIL  ") + padded(r.id, 28) + " " + padded(r.view, 14) +
         column(r.value, "%10.4g") + (r.standard_error ? column(r.standard_error, " ± %.2g") : "") + bounds +
         (r.note.empty() ? "" : " (" + r.note + ")") + "\n";
}

std::string machine_text(const BenchMachine& machine) {
  std::string load;
  for (const double average : machine.load_at_start.value_or(std::vector<double>{})) load += column(average, " %.2f");
  return machine.cpu + "," + column(machine.cores, " %.0f cores,") +
         column(machine.threads, " %.0f threads, load at the start") + (load.empty() ? " unknown" : load) + "\n\n";
}

/// What a view's methods are held against: the first of them; null if there is none.
const BenchMethodResult* baseline_of(const BenchViewResult& view) {
  const auto first = std::find_if(view.methods.begin(), view.methods.end(),
                                  [](const BenchMethodResult& method) { return !method.biased; });
  return first == view.methods.end() ? nullptr : &*first;
}

/// To the level number `index`; without numbers if there is none.
BenchTime time_of(const BenchMethodResult& method, std::size_t index) {
  return index < method.times.size() ? method.times[index] : BenchTime{};
}

/// The method that reaches level number `index` of a view first, biased ones left out; null if none does.
const BenchMethodResult* first_to_reach(const BenchViewResult& view, std::size_t index) {
  const BenchMethodResult* first = nullptr;
  for (const BenchMethodResult& method : view.methods) {
    const Number seconds = time_of(method, index).seconds;
    if (!method.biased && seconds && (!first || *seconds < *time_of(*first, index).seconds)) first = &method;
  }
  return first;
}

/// "1 − SSIM 0.05: ellipses in 0.02 s, sobol in 0.4 s", the second being the view's first method.
std::string race_text(const BenchViewResult& view, const BenchMethodResult& baseline, std::size_t index) {
  const BenchTime level = time_of(baseline, index);
  std::string text(error_kind(level.error).title);
  text += column(level.level, " %g: ");
  const auto entry = [index](const BenchMethodResult& method) {
    const BenchTime time = time_of(method, index);
    const std::string bound = time.status == Reach::AtOnce ? " within" : " in";
    return method.id + (time.seconds ? bound + column(time.seconds, " %.3g s") : " never");
  };
  const BenchMethodResult* first = first_to_reach(view, index);
  if (!first) return text + "nobody";
  return text + entry(*first) + (first == &baseline ? "" : ", " + entry(baseline));
}

}  // namespace

Json bench_sentence(const BenchFindings& found) {
  std::string text;
  for (const BenchViewResult& view : found.views) {
    std::string races;
    if (const BenchMethodResult* baseline = baseline_of(view))
      for (std::size_t i = 0; i < baseline->times.size(); ++i)
        races += (races.empty() ? "" : "; ") + race_text(view, *baseline, i);
    if (!races.empty()) text += (text.empty() ? "" : " ") + view.id + ": " + races + ".";
  }
  return text.empty() ? Json(nullptr) : Json("First to reach an error, and the view's first method. " + text);
}

std::string bench_report_text(const BenchFindings& found) {
  std::string text = machine_text(found.machine);
  for (const BenchViewResult& view : found.views) text += view_text(view) + "\n";
  for (const BenchRequirementResult& r : found.requirements) text += requirement_text(r);
  return text + found.verdict.sentence + "\n";
}

}  // namespace sturm
