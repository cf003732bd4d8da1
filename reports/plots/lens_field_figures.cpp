#include "reports/plots/lens_field_figures.h"

#include <algorithm>
#include <cmath>

#include "compare/studies/lens/lens_study_errors.h"
#include "io/files/formatted_text.h"
#include "reports/markup/drawing.h"
#include "reports/markup/pictures.h"
#include "reports/plots/gnuplot.h"

namespace sturm {

namespace {

struct Series {
  std::optional<FieldEllipse> FieldPoint::*of;
  const char *key, *name, *colour;
};
constexpr Series series[] = {{&FieldPoint::real_rays, "real_rays", "real rays", "#333333"},
                             {&FieldPoint::ray_transfer, "ray_transfer", "ray transfer", "#2166ac"},
                             {&FieldPoint::published, "published", "as published", "#b2182b"},
                             {&FieldPoint::previous, "previous", "previous", "#b8860b"}};

std::string conditions(const LensField& field) {
  const bool infinite = field.distance_m && field.distance_m->is_infinite();
  return field.lens + ", target at " +
         (infinite ? std::string("infinity") : plain_number(finite(field.distance_m).value_or(0.0)) + " m") +
         ", pupil " + plain_number(field.pupil_mm.value_or(0.0)) + " mm.";
}

/// Real rays are measured, so they are points: circles for the major axis, triangles for the minor one.
std::string look_of(const Series& s, const std::string& dash) {
  if (s.of != &FieldPoint::real_rays) return "lines dt " + dash;
  return dash == "1" ? "points pt 6 ps 0.8" : "points pt 8 ps 0.8";
}

std::string rows_of(const LensField& field, const Series& s, std::size_t axis) {
  std::string rows;
  for (const FieldPoint& point : field.points) {
    const Number length = point.*s.of ? (point.*s.of)->semi_axes_arcmin[axis] : std::nullopt;
    if (point.azimuth_deg && length)
      rows += plain_number(*point.azimuth_deg, 9) + " " + plain_number(*length, 9) + "\n";
  }
  return rows;
}

std::optional<Ellipse> ellipse_of(const std::optional<FieldEllipse>& entry) {
  if (!entry || !entry->semi_axes_arcmin[0] || !entry->semi_axes_arcmin[1]) return std::nullopt;
  return Ellipse{*entry->semi_axes_arcmin[0], *entry->semi_axes_arcmin[1], entry->orientation_deg};
}

}  // namespace

std::optional<Figure> field_curves(const LensField& field) {
  std::string blocks, plots;
  for (const Series& s : series)
    for (const auto& [axis, axis_name, dash] : {std::tuple(0u, "major", "1"), std::tuple(1u, "minor", "2")}) {
      const std::string rows = rows_of(field, s, axis);
      if (rows.empty()) continue;
      const std::string name = std::string("$") + s.key + std::to_string(axis);
      blocks += name + " << END\n" + rows + "END\n";
      plots += (plots.empty() ? "plot " : ", ") + name + " with " + look_of(s, dash) + " lw 1.7 lc rgb '" + s.colour +
               "' title '" + s.name + ", " + axis_name + "'";
    }
  if (plots.empty()) return std::nullopt;
  const std::string script = R"(
set border 3 lc rgb '#666666'
set tics nomirror out
set grid ytics lc rgb '#e4e4e4' lw 1 lt 1
set xlabel "gaze to the wearer's right [°]"
set ylabel "semi-axis of the blur [arcmin]"
set yrange [0:*]
set key outside right top Left reverse samplen 2 spacing 1.3
)" + blocks + plots;
  Figure figure;
  figure.id = "lens_study_field";
  figure.section = "lens_study";
  figure.title = "Wide field: semi-axes of the blur against the gaze";
  figure.caption = conditions(field) +
                   " The comparison of Kakimoto's Fig. 14, with real rays as the judge: the previous method scales a "
                   "blur that is right "
                   "inside by a wrong magnification.";
  figure.svg = gnuplot_file(script, {.id = figure.id, .label = figure.title, .width = 1120, .height = 430});
  return figure;
}

std::optional<Figure> field_ellipses(const LensField& field) {
  const std::vector<FieldPoint>& points = field.points;
  double largest = 0.0;
  for (const FieldPoint& point : points)
    for (const Series& s : series)
      if (const auto e = ellipse_of(point.*s.of)) largest = std::max(largest, e->semi_major);
  if (!(largest > 0.0)) return std::nullopt;

  constexpr double label_width = 110.0, width = 1120.0, head = 46.0, foot = 40.0;
  const double cell = (width - label_width) / static_cast<double>(points.size()), scale = 0.46 * cell / largest;
  const double height = head + cell * std::size(series) + foot;
  Html body = white_ground() + svg_text(label_width - 10.0, head - 14.0, "gaze to the right", "end", 12, "#5c6670");
  for (std::size_t row = 0; row < std::size(series); ++row) {
    const double y = head + cell * (static_cast<double>(row) + 0.5);
    body += svg_text(4.0, y + 4.0, series[row].name, "start", 13, series[row].colour);
    for (std::size_t column = 0; column < points.size(); ++column) {
      const double x = label_width + cell * (static_cast<double>(column) + 0.5);
      if (row == 0)
        body += svg_text(x, head - 14.0, plain_number(points[column].azimuth_deg.value_or(0.0)) + "°", "middle", 12,
                         "#5c6670");
      const auto truth = ellipse_of(points[column].real_rays), e = ellipse_of(points[column].*series[row].of);
      if (truth && row > 0)
        body += element("g", {{"fill", "#d9dde2"}, {"stroke", "none"}}, svg_ellipse(*truth, scale, x, y, "truth"));
      if (e)
        body += element("g", {{"fill", "none"}, {"stroke-width", "1.8"}, {"stroke", series[row].colour}},
                        svg_ellipse(*e, scale, x, y, series[row].key));
      else
        body += svg_text(x, y + 4.0, "–");
    }
  }
  const double bar = round_length_below(0.9 * cell / scale), y = height - 16.0;
  body += empty_element(
              "path", {{"d", "M" + plain_number(label_width) + " " + plain_number(y) + "h" + plain_number(bar * scale)},
                       {"stroke", "#333333"},
                       {"stroke-width", "2"}}) +
          "\n"_html + svg_text(label_width + bar * scale + 8.0, y + 4.0, plain_number(bar) + " arcmin", "start", 12);
  Figure figure;
  figure.id = "lens_study_field_ellipses";
  figure.section = "lens_study";
  figure.title = "Wide field: the blur ellipses side by side";
  figure.caption = conditions(field) + " Grey: real rays, behind the outline of each method.";
  figure.svg =
      svg_document(static_cast<int>(std::lround(width)), static_cast<int>(std::lround(height)), figure.title, body);
  return figure;
}

}  // namespace sturm
