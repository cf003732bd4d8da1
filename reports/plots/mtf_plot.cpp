#include "reports/plots/mtf_plot.h"

#include <algorithm>
#include <cmath>

#include "io/files/csv.h"
#include "io/files/formatted_text.h"
#include "reports/plots/plot_style.h"

namespace sturm {

namespace {

/// The number of `value` among those that came before it.
std::size_t number_of(double value, std::vector<double>& known) {
  const auto found = std::find(known.begin(), known.end(), value);
  if (found == known.end()) known.push_back(value);
  return static_cast<std::size_t>(std::find(known.begin(), known.end(), value) - known.begin());
}

std::string csv_of(std::span<const MtfCurve> curves) {
  CsvWriter csv;
  for (const char* heading : {"model", "distance_m", "direction_deg", "frequency_cpd", "mtf"}) csv.text(heading);
  csv.end_row();
  for (const MtfCurve& curve : curves)
    for (std::size_t i = 0; i < curve.values.size(); ++i) {
      csv.text(curve.model);
      if (std::isinf(curve.distance_m))
        csv.text("inf");
      else
        csv.number(curve.distance_m);
      csv.number(curve.direction_deg);
      csv.number(curve.frequencies_cpd[i]);
      csv.number(curve.values[i]);
      csv.end_row();
    }
  return csv.table();
}

}  // namespace

Plot mtf_plot(std::span<const MtfCurve> curves) {
  constexpr const char* dashes[] = {"1", "(9,5)", "(2,3)", "(9,3,2,3)"};
  std::string blocks, plots;
  std::vector<double> distances, directions;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const MtfCurve& curve = curves[i];
    std::string rows;
    for (std::size_t k = 0; k < curve.values.size(); ++k)
      rows += plain_number(curve.frequencies_cpd[k]) + " " + plain_number(curve.values[k], 8) + "\n";
    const std::string name = "curve" + std::to_string(i);
    blocks += data_block(name, rows);
    plots += (i ? ", $" : "$") + name + " with lines lw " + (curve.model == "waves" ? "2.4" : "1.2") + " dt " +
             dashes[number_of(curve.direction_deg, directions) % std::size(dashes)] + " lc rgb '" +
             plot_colour(number_of(curve.distance_m, distances)) + "' title " +
             plot_string(distance_words(curve.distance_m) + ", along " + plain_number(curve.direction_deg, 4) + "°, " +
                         curve.model);
  }
  std::string script = plot_axes;
  script +=
      "set xlabel 'spatial frequency [cycles/degree]'\nset ylabel 'modulation transfer'\nset yrange [0:1]\n"
      "set xrange [0:*]\nset key outside right top Left reverse samplen 3 spacing 1.2 maxcols 1\n";
  constexpr int usual_height = 420, margins = 80, line_height = 19;
  const int legend_height = margins + line_height * static_cast<int>(curves.size());
  return {script + blocks + "plot " + plots + "\n",
          {.id = "mtf",
           .label = "Modulation transfer against spatial frequency",
           .width = 820,
           .height = std::max(usual_height, legend_height)},
          csv_of(curves)};
}

}  // namespace sturm
