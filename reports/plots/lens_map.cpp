#include "reports/plots/lens_map.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "io/files/csv.h"
#include "io/files/formatted_text.h"
#include "reports/markup/false_colour.h"
#include "reports/plots/contour_lines.h"
#include "reports/plots/gnuplot.h"
#include "reports/plots/plot_style.h"

namespace sturm {

namespace {

constexpr int map_width = 470, map_height = 450;  // [px]
constexpr double most_contours = 60;

std::string number_text(double value) {
  return plain_number(value, 7);
}

/// End of the scale that all maps of one kind share: their largest size of a value, rounded up to four contours.
double scale_of(std::span<const LensMap> maps, bool signed_scale) {
  double largest = 0.0, step = 0.0;
  for (const LensMap& map : maps) {
    if (map.signed_scale != signed_scale) continue;
    step = std::fmax(step, 4.0 * map.contour_step);
    for (const double value : map.values.reshaped())
      if (std::isfinite(value)) largest = std::fmax(largest, std::abs(value));
  }
  return step * std::fmax(1.0, std::ceil(largest / step - 1e-9));
}

std::string palette(bool signed_scale) {
  constexpr int stops = 21;
  std::string entries;
  for (int i = 0; i < stops; ++i) {
    const double t = double(i) / (stops - 1);
    // Light at zero either way, so that contours can be seen there.
    const DisplayColour c = signed_scale ? diverging_colour(2.0 * t - 1.0) : sequential_colour(1.0 - 0.85 * t);
    char place[16];
    std::snprintf(place, sizeof place, "%.4f", t);
    entries += (i ? ", " : "") + std::string(place) + " '" + hex_colour(c) + "'";
  }
  return "set palette defined (" + entries + ")\n";
}

/// Millimetres of a place in grid coordinates.
struct Scale {
  double rim, step;
  std::string at(const Eigen::Vector2d& p) const {
    return number_text(-rim + step * p.x()) + " " + number_text(-rim + step * p.y());
  }
};

/// The title in gnuplot's double quotes: nothing of it is a command but the two characters that begin a new line.
std::string quoted_title(const std::string& title) {
  std::string quoted;
  for (std::size_t i = 0; i < title.size(); ++i) {
    if (title.compare(i, 2, "\\n") == 0) {
      quoted += title.substr(i++, 2);
    } else if (title[i] == '"') {
      quoted += "\\\"";
    } else {
      if (std::string_view("{}_^@&~").find(title[i]) != std::string_view::npos) quoted += "\\\\";
      quoted += title[i];
    }
  }
  return "\"" + quoted + "\"";
}

/// Contours of one look: their points, and where their values stand.
struct Contours {
  std::string lines, labels;

  void add(const Eigen::MatrixXd& values, double level, const Scale& scale, const std::string& label = "") {
    constexpr std::size_t least_labelled = 24;  // a shorter line has no room for its value
    for (const ContourLine& line : joined(contour_lines(values, level))) {
      for (const Eigen::Vector2d& point : line) lines += scale.at(point) + "\n";
      lines += "\n";
      if (!label.empty() && line.size() > least_labelled)
        labels += scale.at(line[line.size() / 2]) + " " + label + "\n";
    }
  }
};

std::string panel(const LensMap& map, double limit, int number) {
  const double rim = map.rim_radius_mm;
  const Scale scale{rim, 2.0 * rim / double(map.values.cols() - 1)};
  const std::string id = std::to_string(number);
  std::string places;
  for (Eigen::Index row = 0; row < map.values.rows(); ++row)
    for (Eigen::Index column = 0; column < map.values.cols(); ++column) {
      const double value = map.values(row, column);
      places +=
          scale.at({double(column), double(row)}) + " " + (std::isfinite(value) ? number_text(value) : "NaN") + "\n";
    }
  const double step = map.contour_step * std::ceil(2.0 * limit / map.contour_step / most_contours);
  const int last = static_cast<int>(std::floor(limit / step + 1e-9));
  Contours thin, thick, heavy;
  // No line at 0: the colour is white there, and whole regions may have that value.
  for (int k = map.signed_scale ? -last : 1; k <= last; ++k)
    if (k % 4 != 0)
      thin.add(map.values, k * step, scale);
    else if (k != 0)
      thick.add(map.values, k * step, scale, (k > 0 && map.signed_scale ? "+" : "") + plain_number(k * step, 4));
  std::string script = data_block("places" + id, places);
  std::string curves = "$places" + id + " with image notitle";
  const auto add = [&](const std::string& name, const std::string& rows, const std::string& look) {
    if (rows.empty()) return;
    script += data_block(name + id, rows);
    curves += ", $" + name + id + " " + look + " notitle";
  };
  add("thin", thin.lines, "with lines lw 0.7 lc rgb '#555555'");
  add("thick", thick.lines, "with lines lw 1.6 lc rgb '#222222'");
  if (map.limit_values) heavy.add(*map.limit_values, map.limit, scale);
  add("limit", heavy.lines, "with lines lw 3.2 lc rgb '#007a33'");
  add("labels", thick.labels, "using 1:2:3 with labels boxed font ',10' tc rgb '#222222'");
  script += palette(map.signed_scale) + "set title " + quoted_title(map.title) + "\nset cblabel \"" + map.unit +
            "\"\nset cbrange [" + number_text(map.signed_scale ? -limit : 0.0) + ":" + number_text(limit) +
            "]\nset xrange [" + number_text(-1.05 * rim) + ":" + number_text(1.05 * rim) + "]\nset yrange [" +
            number_text(-1.05 * rim) + ":" + number_text(1.05 * rim) + "]\n";
  return script + "plot " + curves + ", [t=0:2*pi] '+' using (" + number_text(rim) + "*cos($1)):(" + number_text(rim) +
         "*sin($1)) with lines lw 1.5 lc rgb '#000000' notitle, '+' using (" + number_text(map.fitting_cross_mm.x()) +
         "):(" + number_text(map.fitting_cross_mm.y()) +
         ") every 1000 with points pt 1 ps 1.6 lw 2 lc rgb '#000000' notitle\n";
}

std::string one_line(std::string title) {
  for (std::size_t at; (at = title.find("\\n")) != std::string::npos;) title.replace(at, 2, ", ");
  return title;
}

PlotFrame frame_of(std::span<const LensMap> maps, const std::string& id, std::size_t rows = 1) {
  std::string label;
  for (const LensMap& map : maps) label += (label.empty() ? "" : "; ") + one_line(map.title);
  return {.id = id,
          .label = label,
          .width = map_width * static_cast<int>(maps.size() / rows),
          .height = map_height * static_cast<int>(rows)};
}

std::string csv_of(std::span<const LensMap> maps) {
  CsvWriter csv;
  for (const char* heading : {"map", "unit", "x_mm", "y_mm", "value"}) csv.text(heading);
  csv.end_row();
  for (const LensMap& map : maps) {
    const double rim = map.rim_radius_mm, step = 2.0 * rim / double(map.values.cols() - 1);
    for (Eigen::Index row = 0; row < map.values.rows(); ++row)
      for (Eigen::Index column = 0; column < map.values.cols(); ++column) {
        if (!std::isfinite(map.values(row, column))) continue;
        csv.text(one_line(map.title));
        csv.text(map.unit);
        csv.number(-rim + step * double(column));
        csv.number(-rim + step * double(row));
        csv.number(map.values(row, column));
        csv.end_row();
      }
  }
  return csv.table();
}

}  // namespace

std::string lens_map_script(std::span<const LensMap> maps, const LensMapLayout& layout) {
  std::string script = R"(
set size ratio -1
set border 3 lc rgb '#666666'
set tics nomirror out
unset key
set samples 361
set trange [0:2*pi]
set xlabel "to the wearer's right [mm]"
set ylabel "up [mm]"
set style textbox opaque noborder fillcolor rgb '#ffffff' margins 0.4,0.2
set multiplot layout )" +
                       std::to_string(layout.rows) + "," + std::to_string(maps.size() / layout.rows) + "\n";
  int number = 0;
  for (const LensMap& map : maps)
    script += panel(map, layout.range ? *layout.range : scale_of(maps, map.signed_scale), ++number);
  return script + "unset multiplot\n";
}

Plot lens_map_plot(std::span<const LensMap> maps, const LensMapLayout& layout) {
  return {lens_map_script(maps, layout), frame_of(maps, "map", layout.rows), csv_of(maps)};
}

Html lens_map_svg(std::span<const LensMap> maps, const std::string& id) {
  return gnuplot_svg(lens_map_script(maps), frame_of(maps, id));
}

std::string lens_map_svg_file(std::span<const LensMap> maps) {
  return gnuplot_labelled_file(lens_map_script(maps), frame_of(maps, "map"));
}

std::string lens_map_png_file(std::span<const LensMap> maps) {
  return gnuplot_png(lens_map_script(maps), frame_of(maps, "map"));
}

}  // namespace sturm
