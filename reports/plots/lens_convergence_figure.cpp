#include "reports/plots/lens_convergence_figure.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/studies/lens/lens_study_errors.h"
#include "compare/studies/lens/lens_study_views.h"
#include "io/files/formatted_text.h"
#include "io/json/stored.h"
#include "lensmodel/units.h"
#include "reports/plots/gnuplot.h"

namespace sturm {

namespace {

/// ‖C_method − C_rays‖_F [arcmin²] at one pupil: the relative error times the norm of the real rays' covariance, whose
/// eigenvalues are the squares of half the semi-axes.
std::optional<double> absolute_error(const Json& pupil, const char* method) {
  const auto relative = number_at(value_at(pupil, method), "relative_frobenius");
  const auto major = number_at(pupil, "real_semi_axes_arcmin/0"), minor = number_at(pupil, "real_semi_axes_arcmin/1");
  if (!relative || !major || !minor) return std::nullopt;
  return *relative * 0.25 * std::hypot(*major * *major, *minor * *minor);
}

std::string rows_of(const Json& view, const char* method) {
  std::string rows;
  for (const Json& pupil : array_at(view, "pupils")) {
    const auto error = absolute_error(pupil, method), diameter = number_at(pupil, "pupil_mm");
    if (error && diameter && *error > 0.0) rows += plain_number(*diameter, 9) + " " + plain_number(*error, 9) + "\n";
  }
  return rows;
}

/// The oblique view of a lens in which ray transfer errs most at the smallest pupil; null if there is none.
const Json* worst_view(const Json& section, const std::string& lens) {
  const Json* worst = nullptr;
  double largest = 0.0;
  for (const Json& view : array_at(section, "views")) {
    const Json& pupils = array_at(view, "pupils");
    if (text_at(view, "lens") != lens || pupils.empty() || !(number_at(view, "eccentricity_deg").value_or(0.0) > 0.0))
      continue;
    const double error = absolute_error(pupils.front(), "ray_transfer").value_or(0.0);
    if (error > largest) {
      largest = error;
      worst = &view;
    }
  }
  return worst;
}

double published_error(const Json& view) {
  return number_at(view, "first_order/published/defocus_D").value_or(0.0);
}

constexpr const char* colours[] = {"#08519c", "#3182bd", "#6baed6", "#238b45", "#74c476", "#54278f",
                                   "#9e9ac8", "#d94801", "#fd8d3c", "#636363", "#969696", "#000000"};

}  // namespace

std::optional<Figure> convergence_figure(const Json& section) {
  std::string blocks, plots, guide_anchor;
  std::size_t count = 0;
  const auto add = [&](const std::string& rows, const std::string& look, const std::string& title) {
    if (rows.empty()) return;
    const std::string name = "$series" + std::to_string(++count);
    blocks += name + " << END\n" + rows + "END\n";
    plots += (plots.empty() ? "plot " : ", ") + name + " with linespoints " + look + " title \"" + title + "\"";
  };
  std::size_t number = 0;
  const Json* shown = nullptr;  // the view in which eq. 11 errs most
  double largest_published = 0.0;
  for (const Json& lens : array_at(section, "lenses")) {
    const Json* view = worst_view(section, text_at(lens, "id"));
    if (!view) continue;
    const double published = published_error(*view);
    if (!shown || published > largest_published) {
      shown = view;
      largest_published = published;
    }
    const char* colour = colours[number++ % std::size(colours)];
    add(rows_of(*view, "ray_transfer"), std::string("pt 7 ps 0.5 lw 1.6 lc rgb '") + colour + "'", text_at(lens, "id"));
  }
  if (!shown) return std::nullopt;
  add(rows_of(*shown, "published"), "pt 5 ps 0.6 lw 1.6 dt 2 lc rgb '#b2182b'",
      "as published, " + text_at(*shown, "lens"));
  add(rows_of(*shown, "previous"), "pt 9 ps 0.7 lw 1.6 dt 3 lc rgb '#b8860b'", "previous, " + text_at(*shown, "lens"));
  const double start = absolute_error(array_at(*shown, "pupils").front(), "ray_transfer").value_or(1e-6),
               pupil = number_at(array_at(*shown, "pupils").front(), "pupil_mm").value_or(1.0);
  const std::string script = "set xrange [" + plain_number(0.8 * pupil) + ":*]" + R"(
set border 3 lc rgb '#666666'
set tics nomirror out
set grid lc rgb '#e4e4e4' lw 1 lt 1
set logscale xy
set format y "10^{%T}"
set xtics (0.25, 0.5, 1, 2, 3, 4, 6, 8, 10)
set xlabel "diameter of the pupil [mm]"
set ylabel "absolute error of the covariance [arcmin²]"
set key outside right top Left reverse samplen 2 spacing 1.0 maxcols 1 font ",10" noenhanced title "ray transfer, by lens"
)" + blocks + plots + ", " + plain_number(0.25 * start) +
                             "*(x/" + plain_number(pupil) + ")**4 with lines lw 1 lc rgb '#999999' title 'slope 4', " +
                             plain_number(100.0 * start) + "*(x/" + plain_number(pupil) +
                             ")**2 with lines lw 1 dt 4 lc rgb '#999999' title 'slope 2'";
  Figure figure;
  figure.id = "lens_study_convergence";
  figure.section = "lens_study";
  figure.title = "Absolute error against the pupil";
  figure.caption =
      "Frobenius norm of the difference of the covariances from real rays, for each lens in the oblique view "
      "(eccentricity, direction, "
      "distance) in which ray transfer errs most; the other two methods in the view in which eq. 11 errs most. Ray "
      "transfer falls with the fourth power of the pupil: only the lens's aberration is left. A method with a "
      "first-order error falls with "
      "the second.";
  figure.svg = gnuplot_file(script, {.id = figure.id, .label = figure.title, .width = 1120, .height = 520});
  return figure;
}

}  // namespace sturm
