#include "reports/plots/sin2_plots.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/files/formatted_text.h"
#include "io/json/stored.h"
#include "reports/markup/parts.h"
#include "reports/plots/gnuplot.h"

namespace sturm {

namespace {

constexpr const char* style = R"(
set border 3 lc rgb '#666666'
set tics nomirror out
set grid ytics lc rgb '#e4e4e4' lw 1 lt 1
set key bottom right Left reverse samplen 1.5 spacing 1.3 opaque
)";

constexpr const char* ratio_axis = R"plot(
set xrange [-1.05:1.05]
set xlabel "t = V_2 / V_1,  |V_1| ≥ |V_2|" offset 0,-1.6
set bmargin 6
set xtics ("−1\ncircle of least\nconfusion" -1, "−0.5" -0.5, "0\nfocal line" 0, "0.5" 0.5, "1\nno astigmatism\nin the blur" 1)
set samples 1001
)plot";

std::string data_block(const std::string& name, const std::string& rows) {
  return "$" + name + " << END\n" + rows + "END\n";
}

std::string point(double x, double y) {
  return plain_number(x, 9) + " " + plain_number(y, 9) + "\n";
}

/// V₂/V₁ with the larger in the denominator; nothing where both vanish.
std::optional<double> ratio_of_vergences(const Json& row) {
  const auto v1 = number_at(row, "V1_D"), v2 = number_at(row, "V2_D");
  if (!v1 || !v2 || (*v1 == 0.0 && *v2 == 0.0)) return std::nullopt;
  return std::abs(*v1) >= std::abs(*v2) ? *v2 / *v1 : *v1 / *v2;
}

struct RatioPlot {
  std::string key, axis_label, closed_form, range;
};

Html ratio_plot(const Json& table, const RatioPlot& plot) {
  std::string rows;
  for (const Json& row : table) {
    const auto t = ratio_of_vergences(row), ratio = number_at(row, plot.key);
    if (t && ratio && *ratio > 0.0) rows += point(*t, *ratio);
  }
  if (rows.empty()) return {};
  const std::string script =
      std::string(style) + ratio_axis + plot.range + data_block("measured", rows) + "set ylabel \"" + plot.axis_label +
      "\"\nplot 1 with lines lw 2 lc rgb '#2166ac' title 'wavefront theory: 1', " + plot.closed_form +
      " with lines lw 1.5 lc rgb '#333333' title 'closed form of sin²', "
      "$measured with points pt 6 ps 0.7 lw 1.4 lc rgb '#b2182b' title 'sin² rays, measured'";
  return gnuplot_svg(script, {.id = slug(plot.key),
                              .label = plot.axis_label + " against V2/V1: measured points on the closed-form curve",
                              .height = 430});
}

/// ‖a − b‖_F/‖b‖_F of symmetric matrices [xx, xy, yy].
std::optional<double> relative_difference(const Json& a, const Json& b) {
  double difference = 0.0, size = 0.0;
  for (int i = 0; i < 3; ++i) {
    const auto x = number_at(a, std::to_string(i)), y = number_at(b, std::to_string(i));
    if (!x || !y) return std::nullopt;
    const double weight = i == 1 ? 2.0 : 1.0;
    difference += weight * (*x - *y) * (*x - *y);
    size += weight * *y * *y;
  }
  return size > 0.0 ? std::optional(std::sqrt(difference / size)) : std::nullopt;
}

std::string differences_of(const Json& cases, const std::string& ray_model) {
  std::string rows;
  for (const Json& item : cases) {
    const auto cylinder = number_at(item, "cylinder_D");
    for (const Json& rays : array_at(item, "rays")) {
      if (text_at(rays, "ray_model") != ray_model) continue;
      const auto difference = number_at(rays, "against_conoid/relative_frobenius");
      if (cylinder && difference && *difference > 0.0) rows += point(std::abs(*cylinder), *difference);
    }
  }
  return rows;
}

std::string closed_form_differences(const Json& cases) {
  std::string rows;
  for (const Json& item : cases) {
    const auto cylinder = number_at(item, "cylinder_D");
    const auto difference = relative_difference(value_at(item, "sin2_closed_form/covariance_rad2"),
                                                value_at(item, "conoid/covariance_rad2"));
    if (cylinder && difference && *difference > 1e-9) rows += point(std::abs(*cylinder), *difference);
  }
  return rows;
}

}  // namespace

Html sin2_ratio_plots(const Json& report) {
  const Json& table = array_at(report, "sin2/table");
  return ratio_plot(table, {.key = "ratio_major",
                            .axis_label = "major semi-axis, sin² ÷ true",
                            .closed_form = "sqrt((5 + 2*x + x**2)/8)",
                            .range = "set yrange [0.6:1.15]\n"}) +
         ratio_plot(table, {.key = "ratio_minor",
                            .axis_label = "minor semi-axis, sin² ÷ true (logarithmic)",
                            .closed_form = "sqrt((1 + 2*x + 5*x**2)/8)/abs(x)",
                            .range = "set logscale y\nset yrange [0.5:*<1000]\nset key top right\n"});
}

Html difference_plot(const Json& report) {
  const Json& cases = array_at(report, "ellipses/cases");
  struct Series {
    std::string name, title, look, rows;
  };
  const Series all[] = {
      {"sin2", "sin² rays", "pt 6 ps 0.7 lw 1.4 lc rgb '#b2182b'", differences_of(cases, "sin2_radial")},
      {"closed", "closed form of sin²", "pt 2 ps 0.5 lw 1 lc rgb '#333333'", closed_form_differences(cases)},
      {"thin", "spherical-equivalent rays", "pt 8 ps 0.7 lw 1.2 lc rgb '#b8860b'", differences_of(cases, "thin_lens")},
      {"matrix", "power-matrix rays", "pt 4 ps 0.6 lw 1.4 lc rgb '#2166ac'", differences_of(cases, "power_matrix")}};
  std::string blocks, plots;
  for (const Series& series : all) {
    if (series.rows.empty()) continue;
    blocks += data_block(series.name, series.rows);
    plots += std::string(plots.empty() ? "plot " : ", ") + "$" + series.name + " with points " + series.look +
             " title '" + series.title + "'";
  }
  if (plots.empty()) return {};
  const std::string script = std::string(style) + R"(
set xlabel "|cylinder| of the prescription [D]"
set ylabel "relative difference of the covariance from the conoid"
set logscale y
set format y "10^{%T}"
set xrange [-0.1:*]
set offsets 0, 0.1, 0, 0
set xtics 0.5
set key outside top center horizontal
)" + blocks + plots;
  return gnuplot_svg(script, {.id = "difference",
                              .label = "Relative difference between ray bundles and the conoid against the cylinder",
                              .width = 1120,
                              .height = 430});
}

}  // namespace sturm
