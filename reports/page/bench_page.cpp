#include "reports/page/bench_page.h"

#include <cmath>

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

Html machine_facts(const BenchMachine& machine) {
  Html load;
  for (const double average : machine.load_at_start.value_or(std::vector<double>{}))
    add_item(load, number_html(average, 3));
  const Number memory = machine.memory_bytes;
  return fact("Processor", text_or_dash(machine.cpu)) +
         fact("Cores, logical processors, threads used", exact_html(machine.cores) + ", "_html +
                                                             exact_html(machine.logical_processors) + ", "_html +
                                                             exact_html(machine.threads)) +
         fact("Memory", memory ? number_html(*memory / (1 << 30), 3) + " GiB"_html : Html()) +
         fact("Load at the start (1, 5, 15 min)", load);
}

Html header(const Json& report, const BenchFindings& found) {
  // Without a requirement nothing was passed.
  const bool asked = !found.requirements.empty(), passed = found.verdict.passed;
  const Html word = asked ? (passed ? "Passed"_html : "Failed"_html) : "Measured"_html;
  const std::string css_class = std::string("verdict") + (asked ? (passed ? " pass" : " fail") : "");
  return element(
      "header", {{"id", "verdict"}},
      element("p", {{"class", "kind"}}, "Sturm: run time against error"_html) +
          element("h1", text_or_dash(found.title)) +
          element("div", {{"class", css_class}, {"role", "status"}},
                  element("p", {{"class", "word"}}, word) +
                      element("p", {{"class", "sentence"}}, text_or_dash(found.verdict.sentence))) +
          fact_list(fact("Command", code_html(text_at(report, "command"))) +
                    fact("Rounds", exact_html(number_at(report, "spec/rounds"))) +
                    fact("Seed", exact_html(number_at(report, "spec/seed"))) + machine_facts(found.machine)));
}

Html bounds_html(const BenchRequirementResult& r) {
  const Number &low = r.at_least, &high = r.at_most;
  return low && high ? exact_html(low) + " … "_html + exact_html(high)
         : low       ? "≥ "_html + exact_html(low)
                     : "≤ "_html + exact_html(high);
}

Html requirement_table(const std::vector<BenchRequirementResult>& requirements) {
  if (requirements.empty()) return {};
  HtmlTable table(
      "What is required, and what was measured", "gates",
      {{"Requirement"_html, false}, {"View"_html, false}, {"Value"_html}, {"Bound"_html}, {"Result"_html, false}});
  for (const BenchRequirementResult& r : requirements) {
    const std::string what =
        r.statistic + " of " + r.error + ", " + r.method + (r.baseline ? " against " + *r.baseline : "");
    table.add_row(
        {element("span", {{"class", "title"}}, text_or_dash(r.title)) + remark(what) + remark("bound: " + r.reason),
         text_or_dash(r.view), measured_html(r.value, r.standard_error) + remark(r.note), bounds_html(r),
         mark_html(r.passed, r.passed ? "holds"_html : "does not hold"_html)},
        r.passed ? "" : "fail");
  }
  return table.html();
}

Html requirement_section(const BenchFindings& found) {
  const Html table = requirement_table(found.requirements);
  return table.empty() ? Html()
                       : element("section", {{"id", "requirements"}}, element("h2", "Requirements"_html) + table);
}

/// The name of a method in a table; a filtered picture's is marked.
Html method_html(const BenchMethodResult& method) {
  return text_or_dash(method.id) + remark(method.biased ? "filtered: biased, no measure of agreement" : "");
}

Html setting_table(const BenchViewResult& view) {
  std::vector<Column> columns = {{"Method"_html, false},
                                 {"Samples<br/>per pixel"_html},
                                 {"Camera rays<br/>per pixel"_html},
                                 {"Time [s]"_html},
                                 {"Samples<br/>per second"_html}};
  for (const ErrorKind& kind : error_kinds) columns.push_back({text(kind.title)});
  columns.push_back({"RMSE² × s"_html});
  HtmlTable table("Every setting: medians of the times, means of the errors with standard errors", "sortable", columns);
  for (const BenchMethodResult& method : view.methods)
    for (const BenchPoint& point : method.points) {
      const Number rays_per_pixel = point.samples ? Number(*point.samples / view.pixels()) : std::nullopt;
      std::vector<Cell> cells = {
          method_html(method) + remark(point.setting),
          {exact_html(point.samples_per_pixel), point.samples_per_pixel},
          {number_html(rays_per_pixel, 3), rays_per_pixel},
          {number_html(point.seconds.median, 3) + element("small", number_html(point.seconds.shortest, 3) + " … "_html +
                                                                       number_html(point.seconds.longest, 3)),
           point.seconds.median},
          {number_html(point.samples_per_second, 3), point.samples_per_second}};
      for (const ErrorKind& kind : error_kinds) {
        const BenchError error = point.error(kind.name);
        const char* note = error.status == FloorStatus::Clear  ? ""
                           : error.status == FloorStatus::Near ? "near the noise floor"
                                                               : "below the noise floor";
        cells.push_back({measured_html(error.value, error.standard_error) + remark(note), error.value});
      }
      const Number cost = point.error("rmse").error_seconds;
      cells.push_back({number_html(cost, 3), cost});
      table.add_row(cells);
    }
  return table.html();
}

Html slope_table(const BenchViewResult& view) {
  std::vector<Column> columns = {{"Method"_html, false}};
  for (const ErrorKind& kind : error_kinds) columns.push_back({text(kind.title)});
  HtmlTable table("Slope of the error against samples, both logarithmic", "compact", columns);
  for (const BenchMethodResult& method : view.methods) {
    std::vector<Cell> cells = {method_html(method)};
    for (const ErrorKind& kind : error_kinds) {
      const BenchSlope slope = method.slope(kind.name);
      cells.push_back(measured_html(slope.slope, slope.standard_error));
    }
    table.add_row(cells);
  }
  return table.html();
}

Html level_html(const std::string& error, const Number& level) {
  if (error == "one_minus_ssim" && level) return "SSIM "_html + exact_html(std::round(1e6 * (1.0 - *level)) / 1e6);
  for (const ErrorKind& kind : error_kinds)
    if (kind.name == error) return text(kind.title) + " "_html + exact_html(level);
  return text_or_dash(error) + " "_html + exact_html(level);
}

Html time_html(const std::optional<Reach>& status, const Number& seconds) {
  if (status == Reach::Never) return "not reached"_html;
  return (status == Reach::AtOnce ? "≤ "_html : Html()) + number_html(seconds, 3);
}

Html time_table(const BenchViewResult& view) {
  if (view.methods.empty() || view.methods.front().times.empty()) return {};
  std::vector<Column> columns = {{"Method"_html, false}};
  for (const BenchTime& time : view.methods.front().times) columns.push_back({level_html(time.error, time.level)});
  HtmlTable table("Time [s] to reach an error, interpolated between settings; ≤: the cheapest setting is there already",
                  "compact sortable", columns);
  for (const BenchMethodResult& method : view.methods) {
    std::vector<Cell> cells = {method_html(method)};
    for (const BenchTime& time : method.times) cells.push_back({time_html(time.status, time.seconds), time.seconds});
    table.add_row(cells);
  }
  return table.html();
}

/// Where the baseline overtakes each method.
Html best_table(const BenchViewResult& view) {
  if (view.ratios.empty()) return {};
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
  for (const BenchRatio& r : view.ratios) {
    if (!r.at_its_best) continue;
    const BenchBest& best = *r.at_its_best;
    table.add_row({text_or_dash(r.method) + remark("baseline: " + r.baseline), text_or_dash(r.error),
                   exact_html(best.samples_per_pixel) + " samples per pixel"_html + remark(best.setting),
                   number_html(best.value, 3), number_html(best.seconds, 3),
                   time_html(best.baseline_status, best.baseline_seconds), number_html(best.times_faster, 3)});
  }
  return table.html();
}

Html ratio_table(const BenchViewResult& view) {
  if (view.ratios.empty()) return {};
  HtmlTable table("Ratios of methods of this run", "compact",
                  {{"Methods"_html, false},
                   {"Error"_html, false},
                   {"Error at equal samples"_html},
                   {"Time for the baseline’s last error"_html},
                   {"Squared error × time"_html}});
  const auto cell = [](const StatisticValue& ratio) {
    return measured_html(ratio.value, ratio.standard_error, 3) + remark(ratio.note);
  };
  for (const BenchRatio& r : view.ratios)
    table.add_row({text_or_dash(r.method) + " ÷ "_html + text_or_dash(r.baseline), text_or_dash(r.error),
                   cell(r.error_ratio), cell(r.time_ratio), cell(r.cost_ratio)});
  return table.html();
}

Html crossover_table(const BenchViewResult& view) {
  if (view.crossovers.empty()) return {};
  HtmlTable table("Where two methods need the same time for the same error", "compact",
                  {{"Methods"_html, false},
                   {"Error"_html, false},
                   {"Time [s]"_html},
                   {"Value"_html},
                   {"Better with more time"_html, false}});
  for (const BenchCrossover& c : view.crossovers)
    table.add_row({text_or_dash(c.methods[0]) + ", "_html + text_or_dash(c.methods[1]), text_or_dash(c.error),
                   number_html(c.seconds, 3), number_html(c.value, 3), text_or_dash(c.better_after)});
  return table.html();
}

Html reference_facts(const BenchReferenceFacts& reference, const std::filesystem::path& run_folder) {
  Html picture;
  if (!reference.picture.empty())
    if (const auto png = file_contents(run_folder / reference.picture))
      picture = empty_element("img", {{"alt", "reference"},
                                      {"style", "max-width: 24rem; width: 100%; image-rendering: pixelated"},
                                      {"src", "data:image/png;base64," + base64({png->begin(), png->end()})}}) +
                "\n"_html;
  Html floors;
  for (const ErrorKind& kind : error_kinds) {
    const auto floor = reference.noise_floor.find(std::string(kind.name));
    const Number value = floor == reference.noise_floor.end() ? std::nullopt : floor->second;
    add_item(floors, text(kind.title) + " "_html + number_html(value, 3));
  }
  return picture + fact_list(fact("Reference, samples per pixel", count_html(reference.samples_per_pixel)) +
                             fact("Made in", duration_html(reference.seconds)) +
                             fact("Made by version, commit",
                                  text_or_dash(reference.version) + ", "_html + text_or_dash(reference.commit)) +
                             fact("Noise floor of the reference", floors) +
                             fact("Pixels that the trimmed error leaves out as too bright",
                                  count_html(reference.pixels_left_out)));
}

/// One view. `figure_section`: what the report's figures of this view name as their section; `heading`: the tag of its
/// title.
Html view_section(const Json& report, const BenchViewResult& view, const std::string& figure_section,
                  const char* heading, const std::filesystem::path& run_folder) {
  Html html = element(heading, text_or_dash(view.title.empty() ? view.id : view.title)) +
              reference_facts(view.reference, run_folder);
  for (const Json& figure : figures_of(report, figure_section)) html += figure_html(figure, run_folder);
  return element("section", {{"id", "view-" + slug(view.id)}},
                 html + time_table(view) + best_table(view) + slope_table(view) + ratio_table(view) +
                     crossover_table(view) + setting_table(view));
}

}  // namespace

std::string bench_report_html(const Json& report, const std::filesystem::path& run_folder) {
  const BenchFindings found = bench_report_findings(report);
  Html links, body;
  for (const BenchViewResult& view : found.views) {
    links += element("li", inline_element("a", {{"href", "#view-" + slug(view.id)}}, text(view.id)));
    body += view_section(report, view, view.id, "h2", run_folder);
  }
  body = header(report, found) + element("nav", {{"aria-label", "Contents"}}, element("ol", links)) +
         requirement_section(found) + body + provenance_section(report);
  return html_page(found.title, body);
}

Html bench_section(const Json& report, const std::filesystem::path& run_folder) {
  const std::optional<BenchFindings> found = bench_findings(report);
  if (!found) return {};
  Html html = element("h2", "Run time against error"_html) + element("p", text_or_dash(found->title)) +
              element("p", text_or_dash(text_at(report, "verdict/bench_sentence"))) +
              fact_list(machine_facts(found->machine)) + requirement_table(found->requirements);
  for (const BenchViewResult& view : found->views)
    html += view_section(report, view, bench_figure_section(view.id), "h3", run_folder);
  return element("section", {{"id", "bench"}}, html);
}

}  // namespace sturm
