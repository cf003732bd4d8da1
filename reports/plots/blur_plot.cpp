#include "reports/plots/blur_plot.h"

#include <algorithm>
#include <cmath>

#include "io/files/csv.h"
#include "io/files/formatted_text.h"
#include "lensmodel/prescription.h"
#include "lensmodel/units.h"
#include "reports/plots/plot_style.h"

namespace sturm {

namespace {

constexpr double tick_distances_m[] = {4.0, 2.0,  1.0,  0.67, 0.5,  0.4,  0.33, 0.25,
                                       0.2, 0.15, 0.12, 0.1,  0.08, 0.06, 0.05};

double nearest_vergence(std::span<const BlurCurve> curves) {
  double largest = 0.0;
  for (const BlurCurve& curve : curves)
    for (const BlurAtDistance& target : curve.targets) largest = std::max(largest, vergence_of(target.distance_m));
  return largest;
}

/// Distances whose labels do not touch each other.
std::string distance_ticks(double largest_D) {
  std::string ticks = "'∞' 0";
  double last = 0.0;
  for (const double distance : tick_distances_m) {
    const double vergence = vergence_of(distance);
    if (vergence > largest_D || vergence - last < 0.07 * largest_D) continue;
    ticks += ", " + plot_string(distance_words(distance)) + " " + plain_number(vergence);
    last = vergence;
  }
  return ticks;
}

std::string rows_of(const BlurCurve& curve, std::optional<double> BlurAtDistance::*axis) {
  std::string rows;
  for (const BlurAtDistance& target : curve.targets)
    rows += target.*axis
                ? plain_number(vergence_of(target.distance_m), 9) + " " + plain_number(*(target.*axis), 9) + "\n"
                : "\n";
  return rows;
}

std::string tint(const BlurCurve& curve, double largest_D, const char* colour, int& number) {
  std::string script;
  for (const ClearInterval& clear : curve.clear)
    script += formatted(
        "set object %d rectangle from first %.9g,graph 0 to first %.9g,graph 1 behind fc rgb '%s' fs transparent solid "
        "0.13 noborder\n",
        ++number, vergence_of(clear.far_m),
        clear.near_m > 0.0 ? std::min(largest_D, vergence_of(clear.near_m)) : largest_D, colour);
  return script;
}

std::string csv_of(std::span<const BlurCurve> curves) {
  CsvWriter csv;
  for (const char* heading : {"eye", "distance_m", "vergence_D", "accommodation_D", "semi_major_arcmin",
                              "semi_minor_arcmin", "orientation_deg", "orientation_tabo_deg", "clear"})
    csv.text(heading);
  csv.end_row();
  for (const BlurCurve& curve : curves)
    for (const BlurAtDistance& target : curve.targets) {
      csv.text(curve.name);
      if (std::isinf(target.distance_m))
        csv.text("inf");
      else
        csv.number(target.distance_m);
      csv.number(vergence_of(target.distance_m));
      for (const auto& number :
           {target.accommodation_D, target.semi_major_arcmin, target.semi_minor_arcmin, target.orientation_deg})
        csv.number(number);
      csv.number(target.orientation_deg ? std::optional(folded_axis_deg(180.0 - *target.orientation_deg))
                                        : std::nullopt);
      csv.text(target.semi_major_arcmin && *target.semi_major_arcmin <= curve.clear_arcmin ? "yes" : "no");
      csv.end_row();
    }
  return csv.table();
}

}  // namespace

std::string clear_words(const std::vector<ClearInterval>& clear) {
  if (clear.empty()) return "clear nowhere within this range";
  std::string words;
  for (const ClearInterval& interval : clear) {
    words += words.empty() ? "clear " : " and ";
    if (interval.near_m > 0.0)
      words += "from " + distance_words(interval.near_m) +
               (std::isinf(interval.far_m) ? " on" : " to " + distance_words(interval.far_m));
    else
      words += std::isinf(interval.far_m) ? "at any distance" : "up to " + distance_words(interval.far_m);
  }
  return words;
}

Plot blur_plot(std::span<const BlurCurve> curves, std::optional<double> range_arcmin) {
  const double largest = nearest_vergence(curves);
  std::string script = plot_axes, blocks, plots, label;
  script +=
      "set border 7\nset xtics nomirror (" + distance_ticks(largest) + ")\nset x2tics nomirror\n" +
      "set xrange [0:" + plain_number(largest) + "]\nset x2range [0:" + plain_number(largest) +
      "]\nset yrange [0:" + (range_arcmin ? plain_number(*range_arcmin) : "*") +
      "]\nset xlabel 'distance of the target' offset 0,0.2\nset x2label 'vergence of the target [D]'\n" +
      "set ylabel 'semi-axis of the blur [arcmin]'\nset key below left Left reverse samplen 2.5 maxrows 4 height 2\n";
  int number = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const BlurCurve& curve = curves[i];
    script += tint(curve, largest, plot_colour(i), number);
    const std::string id = std::to_string(i);
    blocks += data_block("major" + id, rows_of(curve, &BlurAtDistance::semi_major_arcmin)) +
              data_block("minor" + id, rows_of(curve, &BlurAtDistance::semi_minor_arcmin));
    const std::string name = curves.size() > 1 ? curve.name + ", " : "", colour = plot_colour(i);
    plots += (i ? ", " : "") + ("$major" + id) + " with lines lw 2.4 lc rgb '" + colour + "' title " +
             plot_string(name + "longest; " + (curve.clear.empty() ? "" : "tinted: ") + clear_words(curve.clear)) +
             ", $minor" + id + " with lines lw 1.6 dt (8,5) lc rgb '" + colour + "' title " +
             plot_string(name + "shortest");
    label += (label.empty() ? "" : "; ") + name + clear_words(curve.clear);
  }
  if (!curves.empty())
    plots += ", " + plain_number(curves[0].clear_arcmin) +
             " with lines lw 1 dt (2,3) lc rgb '#444444' title 'largest semi-axis that counts as clear'";
  return {script + blocks + "plot " + plots + "\n",
          {.id = "blur", .label = "Blur against distance: " + label, .width = 720, .height = 470},
          csv_of(curves)};
}

}  // namespace sturm
