#include "reports/plots/spot_plot.h"

#include <algorithm>
#include <cmath>

#include "io/files/csv.h"
#include "io/files/formatted_text.h"
#include "reports/markup/pictures.h"
#include "reports/plots/ellipse_outline.h"
#include "reports/plots/plot_style.h"

namespace sturm {

namespace {

constexpr int spot_width = 190, spots_margin = 70, spot_height = 280;

double range_of(std::span<const SpotDiagram> spots) {
  double largest = 0.0;
  for (const SpotDiagram& spot : spots)
    for (const Eigen::Vector2d& p : spot.points) largest = std::max({largest, std::abs(p.x()), std::abs(p.y())});
  return largest > 0.0 ? 1.08 * largest : 1.0;
}

std::string panel(const SpotDiagram& spot, std::size_t number, std::size_t count) {
  const std::string id = std::to_string(number);
  std::string rows;
  for (const Eigen::Vector2d& p : spot.points) rows += plain_number(p.x(), 6) + " " + plain_number(p.y(), 6) + "\n";
  const double whole = spots_margin + spot_width * double(count) + 10.0,
               left = (spots_margin + spot_width * double(number)) / whole,
               right = (spots_margin + spot_width * double(number + 1) - 24.0) / whole;
  return data_block("rays" + id, rows) + data_block("ellipse" + id, ellipse_outline(spot.ellipse, spot.centroid, 1.0)) +
         formatted("set lmargin at screen %.5f\nset rmargin at screen %.5f\n", left, right) + "set title " +
         plot_string(distance_words(spot.distance_m)) + "\n" +
         (number == 0 ? "set ylabel 'up [arcmin]'\nset format y\n" : "unset ylabel\nset format y ''\n") + "plot $rays" +
         id + " with points pt 7 ps 0.13 lc rgb '" + plot_colour(0) + "' notitle, $ellipse" + id +
         " with lines lw 1.8 lc rgb '" + plot_colour(1) + "' notitle\n";
}

std::string csv_of(std::span<const SpotDiagram> spots) {
  CsvWriter csv;
  for (const char* heading : {"distance_m", "x_arcmin", "y_arcmin"}) csv.text(heading);
  csv.end_row();
  for (const SpotDiagram& spot : spots)
    for (const Eigen::Vector2d& p : spot.points) {
      if (std::isinf(spot.distance_m))
        csv.text("inf");
      else
        csv.number(spot.distance_m);
      csv.number(p.x());
      csv.number(p.y());
      csv.end_row();
    }
  return csv.table();
}

}  // namespace

Plot spot_plot(std::span<const SpotDiagram> spots, std::optional<double> range_arcmin) {
  const double range = range_arcmin ? *range_arcmin : range_of(spots);
  std::string script = plot_axes;
  script += "set border 15 lc rgb '#888888'\nset size ratio 1\nset tmargin at screen 0.87\nset bmargin at screen 0.2\n";
  script += formatted("set xrange [%.6g:%.6g]\nset yrange [%.6g:%.6g]\n", -range, range, -range, range);
  script += formatted("set tics %.6g\n", round_length_above(range / 2.5));
  script +=
      "set grid xtics ytics lc rgb '#e8e8e8' lw 1 lt 1\nset label 1 \"to the wearer's right [arcmin]\" at screen "
      "0.5,0.05 center\nset multiplot\n";
  for (std::size_t i = 0; i < spots.size(); ++i) script += panel(spots[i], i, spots.size()) + "unset label 1\n";
  return {script + "unset multiplot\n",
          {.id = "spots",
           .label = "Spot diagrams through focus, as the wearer sees a point of light",
           .width = spots_margin + spot_width * static_cast<int>(spots.size()) + 10,
           .height = spot_height},
          csv_of(spots)};
}

}  // namespace sturm
