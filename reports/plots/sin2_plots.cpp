#include "reports/plots/sin2_plots.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/files/formatted_text.h"
#include "reports/markup/parts.h"
#include "reports/plots/gnuplot.h"
#include "reports/plots/plot_style.h"

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

std::string point(double x, double y) {
  return plain_number(x, 9) + " " + plain_number(y, 9) + "\n";
}

/// V₂/V₁ with the larger in the denominator; nothing where both vanish.
Number ratio_of_vergences(const Sin2Case& c) {
  if (!c.high_D || !c.low_D || (*c.high_D == 0.0 && *c.low_D == 0.0)) return std::nullopt;
  return std::abs(*c.high_D) >= std::abs(*c.low_D) ? *c.low_D / *c.high_D : *c.high_D / *c.low_D;
}

struct RatioPlot {
  Number Sin2Case::*ratio;
  std::string id, axis_label, closed_form, range;
};

Html ratio_plot(const std::vector<Sin2Case>& cases, const RatioPlot& plot) {
  std::string rows;
  for (const Sin2Case& c : cases) {
    const Number t = ratio_of_vergences(c), ratio = c.*plot.ratio;
    if (t && ratio && *ratio > 0.0) rows += point(*t, *ratio);
  }
  if (rows.empty()) return {};
  const std::string script =
      std::string(style) + ratio_axis + plot.range + data_block("measured", rows) + "set ylabel \"" + plot.axis_label +
      "\"\nplot 1 with lines lw 2 lc rgb '#2166ac' title 'wavefront theory: 1', " + plot.closed_form +
      " with lines lw 1.5 lc rgb '#333333' title 'closed form of sin²', "
      "$measured with points pt 6 ps 0.7 lw 1.4 lc rgb '#b2182b' title 'sin² rays, measured'";
  return gnuplot_svg(script, {.id = plot.id,
                              .label = plot.axis_label + " against V2/V1: measured points on the closed-form curve",
                              .height = 430});
}

std::string differences_of(const std::vector<EllipseFinding>& cases, RayModel model) {
  std::string rows;
  for (const EllipseFinding& item : cases)
    for (const RayFinding& rays : item.rays) {
      if (rays.model != model || !rays.against_conoid || !item.cylinder_D) continue;
      const Number& difference = rays.against_conoid->agreement.relative_frobenius;
      if (difference && *difference > 0.0) rows += point(std::abs(*item.cylinder_D), *difference);
    }
  return rows;
}

std::string closed_form_differences(const std::vector<EllipseFinding>& cases) {
  std::string rows;
  for (const EllipseFinding& item : cases) {
    const Number difference = item.predicted_difference();
    if (item.cylinder_D && difference && *difference > 1e-9) rows += point(std::abs(*item.cylinder_D), *difference);
  }
  return rows;
}

}  // namespace

Html sin2_ratio_plots(const std::vector<Sin2Case>& cases) {
  return ratio_plot(cases, {.ratio = &Sin2Case::ratio_major,
                            .id = "ratio-major",
                            .axis_label = "major semi-axis, sin² ÷ true",
                            .closed_form = "sqrt((5 + 2*x + x**2)/8)",
                            .range = "set yrange [0.6:1.15]\n"}) +
         ratio_plot(cases, {.ratio = &Sin2Case::ratio_minor,
                            .id = "ratio-minor",
                            .axis_label = "minor semi-axis, sin² ÷ true (logarithmic)",
                            .closed_form = "sqrt((1 + 2*x + 5*x**2)/8)/abs(x)",
                            .range = "set logscale y\nset yrange [0.5:*<1000]\nset key top right\n"});
}

Html difference_plot(const std::vector<EllipseFinding>& cases) {
  struct Series {
    std::string name, title, look, rows;
  };
  const Series all[] = {
      {"sin2", "sin² rays", "pt 6 ps 0.7 lw 1.4 lc rgb '#b2182b'", differences_of(cases, RayModel::sin2_radial)},
      {"closed", "closed form of sin²", "pt 2 ps 0.5 lw 1 lc rgb '#333333'", closed_form_differences(cases)},
      {"thin", "spherical-equivalent rays", "pt 8 ps 0.7 lw 1.2 lc rgb '#b8860b'",
       differences_of(cases, RayModel::thin_lens)},
      {"matrix", "power-matrix rays", "pt 4 ps 0.6 lw 1.4 lc rgb '#2166ac'",
       differences_of(cases, RayModel::power_matrix)}};
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
