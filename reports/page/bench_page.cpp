#include "reports/page/bench_page.h"

#include <cmath>

#include "compare/studies/bench/measured_view.h"
#include "io/files/text_file.h"
#include "io/json/stored.h"
#include "reports/markup/markup.h"
#include "reports/markup/numbers.h"
#include "reports/markup/pictures.h"
#include "reports/plots/figure.h"
#include "reports/sections/bench/bench_figures.h"
#include "reports/sections/sections.h"
#include "reports/viewer/html_page.h"

namespace sturm {

namespace {

std::string fact(std::string_view name, const std::string& html) {
  return html.empty() || html == "–" ? "" : element("div", "", element("dt", "", name) + element("dd", "", html));
}

std::string machine_facts(const BenchMachine& machine) {
  std::string load;
  for (const double average : machine.load_at_start.value_or(std::vector<double>{}))
    load += (load.empty() ? "" : ", ") + number_html(average, 3);
  const Number memory = machine.memory_bytes;
  return fact("Processor", text_html(machine.cpu)) +
         fact("Cores, logical processors, threads used", exact_html(machine.cores) + ", " +
                                                             exact_html(machine.logical_processors) + ", " +
                                                             exact_html(machine.threads)) +
         fact("Memory", memory ? number_html(*memory / (1 << 30), 3) + " GiB" : "") +
         fact("Load at the start (1, 5, 15 min)", load);
}

std::string header(const Json& report, const BenchFindings& found) {
  // Without a requirement nothing was passed.
  const bool asked = !found.requirements.empty(), passed = found.verdict.passed;
  const std::string word = asked ? (passed ? "Passed" : "Failed") : "Measured";
  return element(
      "header", "id=\"verdict\"",
      element("p", "class=\"kind\"", "Sturm: run time against error") + element("h1", "", text_html(found.title)) +
          element("div",
                  std::string("class=\"verdict") + (asked ? (passed ? " pass" : " fail") : "") + "\" role=\"status\"",
                  element("p", "class=\"word\"", word) +
                      element("p", "class=\"sentence\"", text_html(found.verdict.sentence))) +
          element("dl", "class=\"facts\"",
                  fact("Command", "<code>" + text_html(text_at(report, "command")) + "</code>") +
                      fact("Rounds", exact_html(number_at(report, "spec/rounds"))) +
                      fact("Seed", exact_html(number_at(report, "spec/seed"))) + machine_facts(found.machine)));
}

std::string bounds_html(const BenchRequirementResult& r) {
  const Number &low = r.at_least, &high = r.at_most;
  return low && high ? exact_html(low) + " … " + exact_html(high)
         : low       ? "≥ " + exact_html(low)
                     : "≤ " + exact_html(high);
}

std::string requirement_table(const std::vector<BenchRequirementResult>& requirements) {
  if (requirements.empty()) return "";
  HtmlTable table("What is required, and what was measured", "gates",
                  {{"Requirement", false}, {"View", false}, {"Value"}, {"Bound"}, {"Result", false}});
  for (const BenchRequirementResult& r : requirements) {
    const std::string what =
        r.statistic + " of " + r.error + ", " + r.method + (r.baseline ? " against " + *r.baseline : "");
    table.add_row(
        {element("span", "class=\"title\"", text_html(r.title)) + element("small", "", escaped(what)) +
             element("small", "", "bound: " + escaped(r.reason)),
         text_html(r.view),
         measured_html(r.value, r.standard_error) + (r.note.empty() ? "" : element("small", "", escaped(r.note))),
         bounds_html(r),
         r.passed ? "<span class=\"mark pass\">holds</span>" : "<strong class=\"mark fail\">does not hold</strong>"},
        r.passed ? "" : "fail");
  }
  return table.html();
}

std::string requirement_section(const BenchFindings& found) {
  const std::string table = requirement_table(found.requirements);
  return table.empty() ? "" : element("section", "id=\"requirements\"", element("h2", "", "Requirements") + table);
}

/// The name of a method in a table; a filtered picture's is marked.
std::string method_html(const BenchMethodResult& method) {
  return text_html(method.id) +
         (method.biased ? element("small", "", "filtered: biased, no measure of agreement") : "");
}

std::string setting_table(const BenchViewResult& view) {
  std::vector<Column> columns = {{"Method", false},
                                 {"Samples<br/>per pixel"},
                                 {"Camera rays<br/>per pixel"},
                                 {"Time [s]"},
                                 {"Samples<br/>per second"}};
  for (const ErrorKind& kind : error_kinds) columns.push_back({escaped(kind.title)});
  columns.push_back({"RMSE² × s"});
  HtmlTable table("Every setting: medians of the times, means of the errors with standard errors", "sortable", columns);
  for (const BenchMethodResult& method : view.methods)
    for (const BenchPoint& point : method.points) {
      const Number rays_per_pixel = point.samples ? Number(*point.samples / view.pixels()) : std::nullopt;
      std::vector<Cell> cells = {
          method_html(method) + (point.setting.empty() ? "" : element("small", "", escaped(point.setting))),
          {exact_html(point.samples_per_pixel), point.samples_per_pixel},
          {number_html(rays_per_pixel, 3), rays_per_pixel},
          {number_html(point.seconds.median, 3) +
               element("small", "",
                       number_html(point.seconds.shortest, 3) + " … " + number_html(point.seconds.longest, 3)),
           point.seconds.median},
          {number_html(point.samples_per_second, 3), point.samples_per_second}};
      for (const ErrorKind& kind : error_kinds) {
        const BenchError error = point.error(kind.name);
        const bool near = error.status == FloorStatus::Near;
        const std::string note = error.status == FloorStatus::Clear
                                     ? ""
                                     : element("small", "", near ? "near the noise floor" : "below the noise floor");
        cells.push_back({measured_html(error.value, error.standard_error) + note, error.value});
      }
      const Number cost = point.error("rmse").error_seconds;
      cells.push_back({number_html(cost, 3), cost});
      table.add_row(cells);
    }
  return table.html();
}

std::string slope_table(const BenchViewResult& view) {
  std::vector<Column> columns = {{"Method", false}};
  for (const ErrorKind& kind : error_kinds) columns.push_back({escaped(kind.title)});
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

std::string level_html(const BenchTime& time) {
  const auto& [error, level, seconds, status] = time;
  if (error == "one_minus_ssim" && level) return "SSIM " + exact_html(std::round(1e6 * (1.0 - *level)) / 1e6);
  for (const ErrorKind& kind : error_kinds)
    if (kind.name == error) return escaped(kind.title) + " " + exact_html(level);
  return text_html(error) + " " + exact_html(level);
}

std::string time_html(const std::optional<Reach>& status, const Number& seconds) {
  if (status == Reach::Never) return "not reached";
  return (status == Reach::AtOnce ? "≤ " : "") + number_html(seconds, 3);
}

std::string time_table(const BenchViewResult& view) {
  if (view.methods.empty() || view.methods.front().times.empty()) return "";
  std::vector<Column> columns = {{"Method", false}};
  for (const BenchTime& level : view.methods.front().times) columns.push_back({level_html(level)});
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
std::string best_table(const BenchViewResult& view) {
  if (view.ratios.empty()) return "";
  HtmlTable table(
      "Each method at its least error, and the baseline’s time for the same: with more time the baseline is better",
      "compact",
      {{"Method", false},
       {"Error", false},
       {"Setting", false},
       {"Least error"},
       {"Time [s]"},
       {"Baseline’s time [s]"},
       {"Times faster"}});
  for (const BenchRatio& r : view.ratios) {
    if (!r.at_its_best) continue;
    const BenchBest& best = *r.at_its_best;
    table.add_row({text_html(r.method) + element("small", "", "baseline: " + escaped(r.baseline)), text_html(r.error),
                   exact_html(best.samples_per_pixel) + " samples per pixel" +
                       (best.setting.empty() ? "" : element("small", "", escaped(best.setting))),
                   number_html(best.value, 3), number_html(best.seconds, 3),
                   time_html(best.baseline_status, best.baseline_seconds), number_html(best.times_faster, 3)});
  }
  return table.html();
}

std::string ratio_table(const BenchViewResult& view) {
  if (view.ratios.empty()) return "";
  HtmlTable table("Ratios of methods of this run", "compact",
                  {{"Methods", false},
                   {"Error", false},
                   {"Error at equal samples"},
                   {"Time for the baseline’s last error"},
                   {"Squared error × time"}});
  const auto cell = [](const StatisticValue& ratio) {
    return measured_html(ratio.value, ratio.standard_error, 3) +
           (ratio.note.empty() ? "" : element("small", "", escaped(ratio.note)));
  };
  for (const BenchRatio& r : view.ratios)
    table.add_row({text_html(r.method) + " ÷ " + text_html(r.baseline), text_html(r.error), cell(r.error_ratio),
                   cell(r.time_ratio), cell(r.cost_ratio)});
  return table.html();
}

std::string crossover_table(const BenchViewResult& view) {
  if (view.crossovers.empty()) return "";
  HtmlTable table("Where two methods need the same time for the same error", "compact",
                  {{"Methods", false}, {"Error", false}, {"Time [s]"}, {"Value"}, {"Better with more time", false}});
  for (const BenchCrossover& c : view.crossovers)
    table.add_row({text_html(c.methods[0]) + ", " + text_html(c.methods[1]), text_html(c.error),
                   number_html(c.seconds, 3), number_html(c.value, 3), text_html(c.better_after)});
  return table.html();
}

std::string reference_facts(const BenchReferenceFacts& reference, const std::filesystem::path& run_folder) {
  std::string picture;
  if (!reference.picture.empty())
    if (const auto png = file_contents(run_folder / reference.picture))
      picture =
          "<img alt=\"reference\" style=\"max-width: 24rem; width: 100%; image-rendering: pixelated\" "
          "src=\"data:image/png;base64," +
          base64({png->begin(), png->end()}) + "\"/>\n";
  std::string floors;
  for (const ErrorKind& kind : error_kinds) {
    const auto floor = reference.noise_floor.find(std::string(kind.name));
    floors += (floors.empty() ? "" : ", ") + escaped(kind.title) + " " +
              number_html(floor == reference.noise_floor.end() ? std::nullopt : floor->second, 3);
  }
  return picture + element("dl", "class=\"facts\"",
                           fact("Reference, samples per pixel", count_html(reference.samples_per_pixel)) +
                               fact("Made in", duration_html(reference.seconds)) +
                               fact("Made by version, commit",
                                    text_html(reference.version) + ", " + text_html(reference.commit)) +
                               fact("Noise floor of the reference", floors) +
                               fact("Pixels that the trimmed error leaves out as too bright",
                                    reference.pixels_left_out ? count_html(reference.pixels_left_out) : ""));
}

/// One view. `figure_section`: what the report's figures of this view name as their section; `heading`: the tag of its
/// title.
std::string view_section(const Json& report, const BenchViewResult& view, const std::string& figure_section,
                         const char* heading, const std::filesystem::path& run_folder) {
  std::string html = element(heading, "", text_html(view.title.empty() ? view.id : view.title)) +
                     reference_facts(view.reference, run_folder);
  for (const Json& figure : figures_of(report, figure_section)) html += figure_html(figure, run_folder);
  return element("section", "id=\"view-" + slug(view.id) + "\"",
                 html + time_table(view) + best_table(view) + slope_table(view) + ratio_table(view) +
                     crossover_table(view) + setting_table(view));
}

}  // namespace

std::string bench_report_html(const Json& report, const std::filesystem::path& run_folder) {
  const BenchFindings found = bench_report_findings(report);
  std::string links, body;
  for (const BenchViewResult& view : found.views) {
    links += element("li", "", "<a href=\"#view-" + slug(view.id) + "\">" + escaped(view.id) + "</a>");
    body += view_section(report, view, view.id, "h2", run_folder);
  }
  body = header(report, found) + element("nav", "aria-label=\"Contents\"", element("ol", "", links)) +
         requirement_section(found) + body + provenance_section(report);
  return html_page(found.title, body);
}

std::string bench_section(const Json& report, const std::filesystem::path& run_folder) {
  const std::optional<BenchFindings> found = bench_findings(report);
  if (!found) return "";
  std::string html = element("h2", "", "Run time against error") + element("p", "", text_html(found->title)) +
                     element("p", "", text_html(text_at(report, "verdict/bench_sentence"))) +
                     element("dl", "class=\"facts\"", machine_facts(found->machine)) +
                     requirement_table(found->requirements);
  for (const BenchViewResult& view : found->views)
    html += view_section(report, view, bench_figure_section(view.id), "h3", run_folder);
  return element("section", "id=\"bench\"", html);
}

}  // namespace sturm
