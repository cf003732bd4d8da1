#include "reports/sections/bench/bench_figures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "compare/studies/bench/measured_view.h"
#include "io/files/formatted_text.h"
#include "reports/plots/gnuplot.h"

namespace sturm {

namespace {

constexpr const char* colours[] = {"#2166ac", "#b2182b", "#238b45", "#d94801",
                                   "#54278f", "#b8860b", "#636363", "#0097a7"};

constexpr const char* style = R"(
set border 3 lc rgb '#666666'
set tics nomirror out
set grid lc rgb '#e4e4e4' lw 1 lt 1
set logscale xy
set format "%g"
set key outside right top Left reverse samplen 2 spacing 1.2 noenhanced
)";

/// Range of an axis a little wider than the values, with ticks at 1, 2, 5 × 10ⁿ (at the powers of ten alone over more
/// than three decades).
std::string axis(char name, double smallest, double largest) {
  const double low = 0.8 * smallest, high = 1.25 * largest;
  std::string ticks;
  for (int decade = static_cast<int>(std::floor(std::log10(low))); std::pow(10.0, decade) <= high; ++decade)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double tick = digit * std::pow(10.0, decade);
      if (tick < low || tick > high || (digit > 1.0 && high > 1e3 * low)) continue;
      ticks += (ticks.empty() ? "" : ", ") + plain_number(tick);
    }
  return std::string("set ") + name + "range [" + plain_number(low) + ":" + plain_number(high) + "]\nset " + name +
         "tics (" + ticks + ")\n";
}

struct Series {
  std::string name, title, rows, look;
};

/// What the points of all curves span.
struct Span {
  double low_x = std::numeric_limits<double>::infinity(), high_x = 0.0, low_y = low_x, high_y = 0.0;

  void add(double x, double y) {
    low_x = std::min(low_x, x), high_x = std::max(high_x, x);
    low_y = std::min(low_y, y), high_y = std::max(high_y, y);
  }
};

/// One line of a data block: x, value, and the ends of its error bar (at the lower end not below a hundredth of the
/// value: the axis is logarithmic).
std::string row(double x, const BenchError& error) {
  const double value = *error.value, sigma = error.standard_error.value_or(0.0);
  return plain_number(x, 9) + " " + plain_number(value, 9) + " " +
         plain_number(std::max(value - sigma, 0.01 * value), 9) + " " + plain_number(value + sigma, 9) + "\n";
}

/// A curve for each method of the view, by a number of its points.
std::vector<Series> series_of(const BenchViewResult& view, const std::function<Number(const BenchPoint&)>& x_of,
                              const std::string& error, Span& span) {
  std::vector<Series> result;
  for (const BenchMethodResult& method : view.methods) {
    const std::size_t k = result.size();
    std::string title = method.title.empty() ? method.id : method.title;
    std::erase_if(title, [](char c) { return c == '"' || c == '\\'; });
    Series series{"$series" + std::to_string(k), method.biased ? title + " (biased)" : title, "",
                  std::string("lc rgb '") + colours[k % std::size(colours)] + "'" + (method.biased ? " dt 2" : "")};
    for (const BenchPoint& point : method.points) {
      const Number x = x_of(point);
      const BenchError found = point.error(error);
      if (!x || !found.value) continue;
      series.rows += row(*x, found);
      span.add(*x, *found.value);
    }
    result.push_back(std::move(series));
  }
  return result;
}

std::string plot_of(const std::vector<Series>& all) {
  std::string blocks, plots;
  for (const Series& s : all) {
    if (s.rows.empty()) continue;
    blocks += s.name + " << END\n" + s.rows + "END\n";
    plots += (plots.empty() ? "plot " : ", ") + s.name + " with yerrorlines pt 7 ps 0.6 lw 1.5 " + s.look +
             " title \"" + s.title + "\"";
  }
  return plots.empty() ? "" : blocks + plots;
}

std::string heading(const BenchViewResult& view) {
  return view.title.empty() ? view.id : view.title;
}

/// A line of slope −1/2 through the first point of the first method, drawn a little below it.
std::string guide_line(const BenchViewResult& view) {
  for (const BenchMethodResult& method : view.methods)
    for (const BenchPoint& point : method.points) {
      const Number error = point.error("rmse").value;
      if (point.samples && error)
        return ", " + plain_number(0.8 * *error, 9) + "*(x/" + plain_number(*point.samples / view.pixels(), 9) +
               ")**-0.5 with lines lw 1 dt 3 lc rgb '#666666' title 'slope −1/2'";
    }
  return "";
}

std::optional<Figure> convergence_figure(const BenchViewResult& view) {
  const double per_pixel = 1.0 / view.pixels();
  Span span;
  const auto samples_per_pixel = [&](const BenchPoint& point) {
    return point.samples ? Number(per_pixel * *point.samples) : std::nullopt;
  };
  const std::string plot = plot_of(series_of(view, samples_per_pixel, "rmse", span));
  if (plot.empty()) return std::nullopt;
  Figure figure;
  figure.id = "convergence_" + view.id;
  figure.title = heading(view) + ": RMSE against samples";
  figure.caption =
      "RMSE against the reference, whose own noise is taken off, with standard errors from the scatter of the rounds. "
      "Samples are "
      "camera rays per pixel, guided ones among them.";
  const std::string script =
      std::string(style) + axis('x', span.low_x, span.high_x) + axis('y', span.low_y, span.high_y) +
      "set xlabel \"samples per pixel\"\nset ylabel \"RMSE [radiance]\"\n" + plot + guide_line(view);
  figure.svg = gnuplot_file(script, {.id = figure.id, .label = figure.title, .width = 900, .height = 440});
  return figure;
}

/// Steps along the Pareto front: what the best of all settings reaches in a given time.
std::string front_steps(const BenchViewResult& view, const std::string& error) {
  const auto front = view.pareto.find(error);
  if (front == view.pareto.end()) return "";
  std::string rows;
  for (const BenchFrontPoint& point : front->second)
    if (point.seconds && point.value)
      rows += plain_number(*point.seconds, 9) + " " + plain_number(*point.value, 9) + "\n";
  return rows.empty() ? "" : "$front << END\n" + rows + "END\n";
}

/// The levels that methods were timed to: those of the first one.
std::vector<BenchTime> levels_of(const BenchViewResult& view) {
  return view.methods.empty() ? std::vector<BenchTime>{} : view.methods.front().times;
}

/// A dotted line at each level that the view's methods were timed to.
std::string level_lines(const BenchViewResult& view, const std::string& error, const Span& span) {
  std::string lines;
  for (const BenchTime& time : levels_of(view)) {
    const Number& level = time.level;
    if (time.error != error || !level || *level < 0.8 * span.low_y || *level > 1.25 * span.high_y) continue;
    const std::string y = plain_number(*level, 9);
    lines +=
        "set arrow from graph 0, first " + y + " to graph 1, first " + y + " nohead dt 3 lw 1.5 lc rgb '#666666'\n";
  }
  return lines;
}

/// RMSE and trimmed relative MSE, and the errors that levels were asked for.
std::vector<const ErrorKind*> errors_against_time(const BenchViewResult& view) {
  std::vector<const ErrorKind*> kinds;
  for (const ErrorKind& kind : error_kinds) {
    bool wanted = kind.name == "rmse" || kind.name == "relative_mse_trimmed";
    for (const BenchTime& time : levels_of(view)) wanted = wanted || time.error == kind.name;
    if (wanted) kinds.push_back(&kind);
  }
  return kinds;
}

std::optional<Figure> pareto_figure(const BenchViewResult& view, const ErrorKind& kind) {
  Span span;
  const auto seconds = [](const BenchPoint& point) { return point.seconds.median; };
  const std::string error(kind.name), plot = plot_of(series_of(view, seconds, error, span)),
                                      steps = front_steps(view, error);
  if (plot.empty() || steps.empty()) return std::nullopt;
  Figure figure;
  figure.id = "pareto_" + view.id + "_" + error;
  figure.title = heading(view) + ": " + std::string(kind.title) + " against time";
  figure.caption =
      "Medians of the seconds over all rounds, without loading the scene; grey steps: the best that any setting "
      "reaches in that time "
      "(Pareto front); dotted: errors whose time is asked for.";
  const std::string script = std::string(style) + axis('x', span.low_x, span.high_x) +
                             axis('y', span.low_y, span.high_y) + "set xlabel \"time [s]\"\nset ylabel \"" +
                             std::string(kind.title) + "\"\n" + level_lines(view, error, span) + steps + plot +
                             ", $front using 1:2 with steps lw 4 lc rgb '#66999999' title 'best in that time'";
  figure.svg = gnuplot_file(script, {.id = figure.id, .label = figure.title, .width = 900, .height = 440});
  return figure;
}

}  // namespace

std::vector<Figure> bench_figures(const BenchViewResult& view, const std::string& command) {
  std::vector<Figure> figures;
  if (auto figure = convergence_figure(view)) figures.push_back(std::move(*figure));
  for (const ErrorKind* kind : errors_against_time(view))
    if (auto figure = pareto_figure(view, *kind)) figures.push_back(std::move(*figure));
  for (Figure& figure : figures) {
    figure.section = view.id;
    figure.command = command;
  }
  return figures;
}

std::vector<Figure> bench_figures_of_experiment(const BenchViewResult& view, const std::string& command) {
  std::vector<Figure> figures = bench_figures(view, command);
  for (Figure& figure : figures) {
    figure.id = "bench_" + figure.id;
    figure.section = bench_figure_section(figure.section);
  }
  return figures;
}

std::string bench_figure_section(const std::string& id) {
  return "bench/" + id;
}

}  // namespace sturm
