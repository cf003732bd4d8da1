#include "reports/plots/ellipse_field_plot.h"

#include <algorithm>
#include <cmath>

#include "io/files/csv.h"
#include "io/files/formatted_text.h"
#include "lensmodel/prescription.h"
#include "lensmodel/units.h"
#include "reports/plots/ellipse_outline.h"
#include "reports/plots/plot_style.h"

namespace sturm {

namespace {

constexpr int field_width = 430, field_height = 470;

double largest_of(std::span<const EllipseField> fields) {
  double largest = 0.0;
  for (const EllipseField& field : fields)
    for (const FieldSpot& spot : field.spots)
      if (spot.ellipse) largest = std::max(largest, spot.ellipse->semi_major);
  return largest > 0.0 ? largest : 1.0;
}

std::string panel(const EllipseField& field, double degrees_per_arcmin, std::size_t number) {
  std::string clear, blurred, dots;
  double right = 0.0, up = 0.0;
  for (const FieldSpot& spot : field.spots) {
    const Eigen::Vector2d place(spot.azimuth_deg, spot.elevation_deg);
    right = std::max(right, std::abs(spot.azimuth_deg));
    up = std::max(up, std::abs(spot.elevation_deg));
    dots += plain_number(place.x()) + " " + plain_number(place.y()) + "\n";
    if (spot.ellipse)
      (spot.ellipse->semi_major > field.clear_arcmin ? blurred : clear) +=
          ellipse_outline(*spot.ellipse, place, degrees_per_arcmin);
  }
  const std::string id = std::to_string(number);
  std::string script = data_block("dots" + id, dots),
              curves = "$dots" + id + " with points pt 7 ps 0.15 lc rgb '#999999' notitle";
  const auto add = [&](const std::string& name, const std::string& rows, const char* colour) {
    if (rows.empty()) return;
    script += data_block(name + id, rows);
    curves += ", $" + name + id + " with lines lw 1.5 lc rgb '" + colour + "' notitle";
  };
  add("clear", clear, plot_colour(0));
  add("blurred", blurred, plot_colour(1));
  return script + "set title " + plot_string(field.title) + "\n" +
         formatted("set xrange [%.6g:%.6g]\nset yrange [%.6g:%.6g]\n", -right - 0.7 * field.step_deg,
                   right + 0.7 * field.step_deg, -up - 0.7 * field.step_deg, up + 0.7 * field.step_deg) +
         "plot " + curves + "\n";
}

std::string csv_of(std::span<const EllipseField> fields) {
  CsvWriter csv;
  for (const char* heading : {"field", "azimuth_deg", "elevation_deg", "semi_major_arcmin", "semi_minor_arcmin",
                              "orientation_deg", "orientation_tabo_deg"})
    csv.text(heading);
  csv.end_row();
  for (const EllipseField& field : fields)
    for (const FieldSpot& spot : field.spots) {
      csv.text(field.title);
      csv.number(spot.azimuth_deg);
      csv.number(spot.elevation_deg);
      if (spot.ellipse) {
        const auto& orientation = spot.ellipse->orientation_deg;
        csv.number(spot.ellipse->semi_major);
        csv.number(spot.ellipse->semi_minor);
        csv.number(orientation);
        csv.number(orientation ? std::optional(folded_axis_deg(180.0 - *orientation)) : std::nullopt);
      } else {
        csv.empty(4);
      }
      csv.end_row();
    }
  return csv.table();
}

}  // namespace

Plot ellipse_field_plot(std::span<const EllipseField> fields, std::optional<double> range_arcmin) {
  const double largest = range_arcmin ? *range_arcmin : largest_of(fields);
  const double step = fields.empty() ? 1.0 : fields[0].step_deg, degrees_per_arcmin = 0.48 * step / largest;
  std::string script = plot_axes;
  script +=
      "set size ratio -1\nset border 15 lc rgb '#888888'\nset xlabel \"gaze to the wearer's right [°]\"\n"
      "set ylabel 'gaze up [°]'\nset bmargin 5\nset multiplot layout 1," +
      std::to_string(fields.size()) + "\n";
  script += "set label 1 " +
            plot_string(formatted("longest semi-axis: %.3g arcmin; blue: clear (up to %.3g arcmin)", largest,
                                  fields.empty() ? 0.0 : fields[0].clear_arcmin)) +
            " at screen 0.5,0.025 center font ',11'\n";
  for (std::size_t i = 0; i < fields.size(); ++i) script += panel(fields[i], degrees_per_arcmin, i) + "unset label 1\n";
  return {script + "unset multiplot\n",
          {.id = "ellipses",
           .label = "Blur ellipses over the field of gaze",
           .width = field_width * static_cast<int>(std::max<std::size_t>(1, fields.size())),
           .height = field_height},
          csv_of(fields)};
}

}  // namespace sturm
