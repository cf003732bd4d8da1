#include "reports/page/bench_page.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/studies/bench/measured_view.h"
#include "io/files/text_file.h"
#include "io/json/stored.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/markup/pictures.h"
#include "reports/plots/figure.h"
#include "reports/sections/bench/bench_figures.h"
#include "reports/sections/sections.h"
#include "reports/viewer/html_page.h"

namespace sturm {

namespace {

/// On a line of its own below a value; nothing without words.
Html remark(std::string_view words) {
  return words.empty() ? Html() : element("small", text(words));
}

Html machine_facts(const Json& machine) {
  Html load;
  for (const Json& average : array_at(machine, "load_at_start")) add_item(load, number_html(number_at(average, ""), 3));
  const auto memory = number_at(machine, "memory_bytes");
  return fact("Processor", text_or_dash(text_at(machine, "cpu"))) +
         fact("Cores, logical processors, threads used", exact_html(number_at(machine, "cores")) + ", "_html +
                                                             exact_html(number_at(machine, "logical_processors")) +
                                                             ", "_html + exact_html(number_at(machine, "threads"))) +
         fact("Memory", memory ? number_html(*memory / (1 << 30), 3) + " GiB"_html : Html()) +
         fact("Load at the start (1, 5, 15 min)", load);
}

Html header(const Json& report) {
  // Without a requirement nothing was passed.
  const bool asked = !array_at(report, "requirements").empty(),
             passed = boolean_at(report, "verdict/passed").value_or(false);
  const Html word = asked ? (passed ? "Passed"_html : "Failed"_html) : "Measured"_html;
  const std::string css_class = std::string("verdict") + (asked ? (passed ? " pass" : " fail") : "");
  return element(
      "header", {{"id", "verdict"}},
      element("p", {{"class", "kind"}}, "Sturm: run time against error"_html) +
          element("h1", text_or_dash(text_at(report, "title"))) +
          element("div", {{"class", css_class}, {"role", "status"}},
                  element("p", {{"class", "word"}}, word) +
                      element("p", {{"class", "sentence"}}, text_or_dash(text_at(report, "verdict/sentence")))) +
          fact_list(fact("Command", code_html(text_at(report, "command"))) +
                    fact("Rounds", exact_html(number_at(report, "spec/rounds"))) +
                    fact("Seed", exact_html(number_at(report, "spec/seed"))) +
                    machine_facts(value_at(report, "machine"))));
}

Html bounds_html(const Json& r) {
  const auto low = number_at(r, "at_least"), high = number_at(r, "at_most");
  return low && high ? exact_html(low) + " … "_html + exact_html(high)
         : low       ? "≥ "_html + exact_html(low)
                     : "≤ "_html + exact_html(high);
}

/// What was required of `section`: a report of a benchmark, or a benchmark's section of a report.
Html requirement_table(const Json& section) {
  const Json& list = array_at(section, "requirements");
  if (list.empty()) return {};
  HtmlTable table(
      "What is required, and what was measured", "gates",
      {{"Requirement"_html, false}, {"View"_html, false}, {"Value"_html}, {"Bound"_html}, {"Result"_html, false}});
  for (const Json& r : list) {
    const bool passed = boolean_at(r, "passed").value_or(false);
    const std::string note = text_at(r, "note"), baseline = text_at(r, "baseline");
    const std::string what = text_at(r, "statistic") + " of " + text_at(r, "error") + ", " + text_at(r, "method") +
                             (baseline.empty() ? "" : " against " + baseline);
    table.add_row({element("span", {{"class", "title"}}, text_or_dash(text_at(r, "title"))) + remark(what) +
                       remark("bound: " + text_at(r, "reason")),
                   text_or_dash(text_at(r, "view")),
                   measured_html(number_at(r, "value"), number_at(r, "standard_error")) + remark(note), bounds_html(r),
                   mark_html(passed, passed ? "holds"_html : "does not hold"_html)},
                  passed ? "" : "fail");
  }
  return table.html();
}

Html requirement_section(const Json& report) {
  const Html table = requirement_table(report);
  return table.empty() ? Html()
                       : element("section", {{"id", "requirements"}}, element("h2", "Requirements"_html) + table);
}

/// The name of a method in a table; a filtered picture's is marked.
Html method_html(const Json& method) {
  return text_or_dash(text_at(method, "id")) +
         remark(boolean_at(method, "biased").value_or(false) ? "filtered: biased, no measure of agreement" : "");
}

Html setting_table(const Json& view) {
  const double pixels = number_at(view, "resolution/0").value_or(1.0) * number_at(view, "resolution/1").value_or(1.0);
  std::vector<Column> columns = {{"Method"_html, false},
                                 {"Samples<br/>per pixel"_html},
                                 {"Camera rays<br/>per pixel"_html},
                                 {"Time [s]"_html},
                                 {"Samples<br/>per second"_html}};
  for (const ErrorKind& kind : error_kinds) columns.push_back({text(kind.title)});
  columns.push_back({"RMSE² × s"_html});
  HtmlTable table("Every setting: medians of the times, means of the errors with standard errors", "sortable", columns);
  for (const Json& method : array_at(view, "methods"))
    for (const Json& point : array_at(method, "points")) {
      const auto seconds = number_at(point, "seconds/median");
      const auto rays = number_at(point, "samples");
      const std::optional<double> rays_per_pixel = rays ? std::optional(*rays / pixels) : rays;
      const std::string setting = text_at(point, "setting");
      std::vector<Cell> cells = {
          method_html(method) + remark(setting),
          {exact_html(number_at(point, "samples_per_pixel")), number_at(point, "samples_per_pixel")},
          {number_html(rays_per_pixel, 3), rays_per_pixel},
          {number_html(seconds, 3) +
               element("small", number_html(number_at(point, "seconds/shortest"), 3) + " … "_html +
                                    number_html(number_at(point, "seconds/longest"), 3)),
           seconds},
          {number_html(number_at(point, "samples_per_second"), 3), number_at(point, "samples_per_second")}};
      for (const ErrorKind& kind : error_kinds) {
        const Json& error = value_at(point, "errors/" + std::string(kind.name));
        const std::string status = text_at(error, "status");
        const char* note = status == "ok"                 ? ""
                           : status == "near_noise_floor" ? "near the noise floor"
                                                          : "below the noise floor";
        cells.push_back({measured_html(number_at(error, "value"), number_at(error, "standard_error")) + remark(note),
                         number_at(error, "value")});
      }
      cells.push_back({number_html(number_at(point, "errors/rmse/error_seconds"), 3),
                       number_at(point, "errors/rmse/error_seconds")});
      table.add_row(cells);
    }
  return table.html();
}

Html slope_table(const Json& view) {
  std::vector<Column> columns = {{"Method"_html, false}};
  for (const ErrorKind& kind : error_kinds) columns.push_back({text(kind.title)});
  HtmlTable table("Slope of the error against samples, both logarithmic", "compact", columns);
  for (const Json& method : array_at(view, "methods")) {
    std::vector<Cell> cells = {method_html(method)};
    for (const ErrorKind& kind : error_kinds) {
      const std::string path = "slopes/" + std::string(kind.name);
      cells.push_back(measured_html(number_at(method, path + "/slope"), number_at(method, path + "/standard_error")));
    }
    table.add_row(cells);
  }
  return table.html();
}

Html level_html(const Json& time) {
  const std::string error = text_at(time, "error");
  const auto level = number_at(time, "level");
  if (error == "one_minus_ssim" && level) return "SSIM "_html + exact_html(std::round(1e6 * (1.0 - *level)) / 1e6);
  for (const ErrorKind& kind : error_kinds)
    if (kind.name == error) return text(kind.title) + " "_html + exact_html(level);
  return text_or_dash(error) + " "_html + exact_html(level);
}

Html time_html(const Json& time) {
  const std::string status = text_at(time, "status");
  if (status == "never") return "not reached"_html;
  return (status == "at_once" ? "≤ "_html : Html()) + number_html(number_at(time, "seconds"), 3);
}

Html time_table(const Json& view) {
  const Json& levels = array_at(view, "methods/0/times");
  if (levels.empty()) return {};
  std::vector<Column> columns = {{"Method"_html, false}};
  for (const Json& level : levels) columns.push_back({level_html(level)});
  HtmlTable table("Time [s] to reach an error, interpolated between settings; ≤: the cheapest setting is there already",
                  "compact sortable", columns);
  for (const Json& method : array_at(view, "methods")) {
    std::vector<Cell> cells = {method_html(method)};
    for (const Json& time : array_at(method, "times")) cells.push_back({time_html(time), number_at(time, "seconds")});
    table.add_row(cells);
  }
  return table.html();
}

/// Where the baseline overtakes each method.
Html best_table(const Json& view) {
  HtmlTable table(
      "Each method at its least error, and the baseline’s time for the same: with more time the baseline is better",
      "compact",
      {{"Method"_html, false},
       {"Error"_html, false},
       {"Setting"_html, false},
       {"Least error"_html},
       {"Time [s]"_html},
       {"Baseline’s time [s]"_html},
       {"Times faster"_html}});
  for (const Json& r : array_at(view, "ratios")) {
    const Json& best = value_at(r, "at_its_best");
    if (!best.is_object()) continue;
    const std::string setting = text_at(best, "setting");
    table.add_row(
        {text_or_dash(text_at(r, "method")) + remark("baseline: " + text_at(r, "baseline")),
         text_or_dash(text_at(r, "error")),
         exact_html(number_at(best, "samples_per_pixel")) + " samples per pixel"_html + remark(setting),
         number_html(number_at(best, "value"), 3), number_html(number_at(best, "seconds"), 3),
         time_html({{"status", value_at(best, "baseline_status")}, {"seconds", value_at(best, "baseline_seconds")}}),
         number_html(number_at(best, "times_faster"), 3)});
  }
  return array_at(view, "ratios").empty() ? Html() : table.html();
}

Html ratio_table(const Json& view) {
  const Json& list = array_at(view, "ratios");
  if (list.empty()) return {};
  HtmlTable table("Ratios of methods of this run", "compact",
                  {{"Methods"_html, false},
                   {"Error"_html, false},
                   {"Error at equal samples"_html},
                   {"Time for the baseline’s last error"_html},
                   {"Squared error × time"_html}});
  const auto cell = [](const Json& ratio) {
    const std::string note = text_at(ratio, "note");
    return measured_html(number_at(ratio, "value"), number_at(ratio, "standard_error"), 3) + remark(note);
  };
  for (const Json& r : list)
    table.add_row({text_or_dash(text_at(r, "method")) + " ÷ "_html + text_or_dash(text_at(r, "baseline")),
                   text_or_dash(text_at(r, "error")), cell(value_at(r, "error_ratio")), cell(value_at(r, "time_ratio")),
                   cell(value_at(r, "cost_ratio"))});
  return table.html();
}

Html crossover_table(const Json& view) {
  const Json& list = array_at(view, "crossovers");
  if (list.empty()) return {};
  HtmlTable table("Where two methods need the same time for the same error", "compact",
                  {{"Methods"_html, false},
                   {"Error"_html, false},
                   {"Time [s]"_html},
                   {"Value"_html},
                   {"Better with more time"_html, false}});
  for (const Json& c : list)
    table.add_row({text_or_dash(text_at(c, "methods/0")) + ", "_html + text_or_dash(text_at(c, "methods/1")),
                   text_or_dash(text_at(c, "error")), number_html(number_at(c, "seconds"), 3),
                   number_html(number_at(c, "value"), 3), text_or_dash(text_at(c, "better_after"))});
  return table.html();
}

Html reference_facts(const Json& view, const std::filesystem::path& run_folder) {
  const Json& reference = value_at(view, "reference");
  const auto left_out = number_at(reference, "pixels_left_out");
  Html picture;
  if (const std::string name = text_at(reference, "picture"); !name.empty())
    if (const auto png = file_contents(run_folder / name))
      picture = empty_element("img", {{"alt", "reference"},
                                      {"style", "max-width: 24rem; width: 100%; image-rendering: pixelated"},
                                      {"src", "data:image/png;base64," + base64({png->begin(), png->end()})}}) +
                "\n"_html;
  Html floors;
  for (const ErrorKind& kind : error_kinds)
    add_item(floors, text(kind.title) + " "_html +
                         number_html(number_at(reference, "noise_floor/" + std::string(kind.name)), 3));
  return picture +
         fact_list(fact("Reference, samples per pixel", count_html(number_at(reference, "samples_per_pixel"))) +
                   fact("Made in", duration_html(number_at(reference, "seconds"))) +
                   fact("Made by version, commit", text_or_dash(text_at(reference, "version")) + ", "_html +
                                                       text_or_dash(text_at(reference, "commit"))) +
                   fact("Noise floor of the reference", floors) +
                   fact("Pixels that the trimmed error leaves out as too bright", count_html(left_out)));
}

/// One view. `figure_section`: what the report's figures of this view name as their section; `heading`: the tag of its
/// title.
Html view_section(const Json& report, const Json& view, const std::string& figure_section, const char* heading,
                  const std::filesystem::path& run_folder) {
  const std::string id = text_at(view, "id"), title = text_at(view, "title");
  Html html = element(heading, text_or_dash(title.empty() ? id : title)) + reference_facts(view, run_folder);
  for (const Json& figure : figures_of(report, figure_section)) html += figure_html(figure, run_folder);
  return element("section", {{"id", "view-" + slug(id)}},
                 html + time_table(view) + best_table(view) + slope_table(view) + ratio_table(view) +
                     crossover_table(view) + setting_table(view));
}

}  // namespace

std::string bench_report_html(const Json& report, const std::filesystem::path& run_folder) {
  Html links, body;
  for (const Json& view : array_at(report, "views")) {
    const std::string id = text_at(view, "id");
    links += element("li", inline_element("a", {{"href", "#view-" + slug(id)}}, text(id)));
    body += view_section(report, view, id, "h2", run_folder);
  }
  body = header(report) + element("nav", {{"aria-label", "Contents"}}, element("ol", links)) +
         requirement_section(report) + body + provenance_section(report);
  return html_page(text_at(report, "title"), body);
}

Html bench_section(const Json& report, const std::filesystem::path& run_folder) {
  const Json& section = value_at(report, "bench");
  if (!section.is_object()) return {};
  Html html = element("h2", "Run time against error"_html) + element("p", text_or_dash(text_at(section, "title"))) +
              element("p", text_or_dash(text_at(report, "verdict/bench_sentence"))) +
              fact_list(machine_facts(value_at(section, "machine"))) + requirement_table(section);
  for (const Json& view : array_at(section, "views"))
    html += view_section(report, view, bench_figure_section(text_at(view, "id")), "h3", run_folder);
  return element("section", {{"id", "bench"}}, html);
}

}  // namespace sturm
