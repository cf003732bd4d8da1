#include "reports/plots/lens_map.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "io/files/formatted_text.h"
#include "reports/markup/false_colour.h"
#include "reports/plots/contour_lines.h"
#include "reports/plots/gnuplot.h"

namespace sturm {

namespace {

constexpr int panel_width = 470, panel_height = 450;  // [px]
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

std::string lines_at(const Eigen::MatrixXd& values, double level, const Scale& scale) {
  std::string rows;
  for (const ContourPiece& piece : contour_lines(values, level))
    rows += scale.at(piece[0]) + "\n" + scale.at(piece[1]) + "\n\n";
  return rows;
}

std::string block(const std::string& name, const std::string& rows) {
  return "$" + name + " << END\n" + rows + "END\n";
}

std::string panel(const LensMap& map, double limit, int number) {
  const double rim = map.rim_radius_mm;
  const Scale scale{rim, 2.0 * rim / double(map.values.cols() - 1)};
  const std::string id = std::to_string(number);
  std::string places, thin, thick;
  for (Eigen::Index row = 0; row < map.values.rows(); ++row)
    for (Eigen::Index column = 0; column < map.values.cols(); ++column) {
      const double value = map.values(row, column);
      places +=
          scale.at({double(column), double(row)}) + " " + (std::isfinite(value) ? number_text(value) : "NaN") + "\n";
    }
  const double step = map.contour_step * std::ceil(2.0 * limit / map.contour_step / most_contours);
  const int last = static_cast<int>(std::floor(limit / step + 1e-9));
  // No line at 0: the colour is white there, and whole regions may have that value.
  for (int k = map.signed_scale ? -last : 1; k <= last; ++k)
    if (k != 0) (k % 4 == 0 ? thick : thin) += lines_at(map.values, k * step, scale);
  std::string script = block("places" + id, places) + block("thin" + id, thin) + block("thick" + id, thick);
  std::string curves = "$places" + id + " with image notitle";
  const auto add = [&](const std::string& name, const std::string& rows, const char* look) {
    if (!rows.empty()) curves += ", $" + name + id + " with lines " + look + " notitle";
  };
  add("thin", thin, "lw 0.7 lc rgb '#555555'");
  add("thick", thick, "lw 1.6 lc rgb '#222222'");
  if (map.limit_values) {
    const std::string rows = lines_at(*map.limit_values, map.limit, scale);
    script += block("limit" + id, rows);
    add("limit", rows, "lw 3.2 lc rgb '#007a33'");
  }
  script += palette(map.signed_scale) + "set title \"" + map.title + "\"\nset cblabel \"" + map.unit +
            "\"\nset cbrange [" + number_text(map.signed_scale ? -limit : 0.0) + ":" + number_text(limit) +
            "]\nset xrange [" + number_text(-1.05 * rim) + ":" + number_text(1.05 * rim) + "]\nset yrange [" +
            number_text(-1.05 * rim) + ":" + number_text(1.05 * rim) + "]\n";
  return script + "plot " + curves + ", [t=0:2*pi] '+' using (" + number_text(rim) + "*cos($1)):(" + number_text(rim) +
         "*sin($1)) with lines lw 1.5 lc rgb '#000000' notitle, '+' using (" + number_text(map.fitting_cross_mm.x()) +
         "):(" + number_text(map.fitting_cross_mm.y()) +
         ") every 1000 with points pt 1 ps 1.6 lw 2 lc rgb '#000000' notitle\n";
}

PlotFrame frame_of(std::span<const LensMap> maps, const std::string& id) {
  std::string label;
  for (const LensMap& map : maps) label += (label.empty() ? "" : "; ") + map.title;
  for (std::size_t at; (at = label.find("\\n")) != std::string::npos;) label.replace(at, 2, ", ");
  return {.id = id, .label = label, .width = panel_width * static_cast<int>(maps.size()), .height = panel_height};
}

}  // namespace

std::string lens_map_script(std::span<const LensMap> maps) {
  std::string script = R"(
set size ratio -1
set border 3 lc rgb '#666666'
set tics nomirror out
unset key
set samples 361
set trange [0:2*pi]
set xlabel "to the wearer's right [mm]"
set ylabel "up [mm]"
set multiplot layout 1,)" +
                       std::to_string(maps.size()) + "\n";
  int number = 0;
  for (const LensMap& map : maps) script += panel(map, scale_of(maps, map.signed_scale), ++number);
  return script + "unset multiplot\n";
}

Html lens_map_svg(std::span<const LensMap> maps, const std::string& id) {
  return gnuplot_svg(lens_map_script(maps), frame_of(maps, id));
}

std::string lens_map_svg_file(std::span<const LensMap> maps) {
  std::string svg = lens_map_svg(maps, "map").markup();
  svg.insert(
      4,
      " xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" font-family=\"sans-serif\"");
  return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n" + svg;
}

std::string lens_map_png_file(std::span<const LensMap> maps) {
  return gnuplot_png(lens_map_script(maps), frame_of(maps, "map"));
}

}  // namespace sturm
