#include "reports/plots/lens_convergence_figure.h"

#include <cmath>

#include "compare/studies/lens/lens_study_errors.h"
#include "compare/studies/lens/lens_study_views.h"
#include "io/files/formatted_text.h"
#include "lensmodel/units.h"
#include "reports/plots/gnuplot.h"

namespace sturm {

namespace {

/// ‖C_method − C_rays‖_F [arcmin²] at one pupil: the relative error times the norm of the real rays' covariance, whose
/// eigenvalues are the squares of half the semi-axes.
Number absolute_error(const LensPupil& pupil, std::optional<MethodError> LensPupil::*method) {
  const Number relative = pupil.*method ? (pupil.*method)->relative_frobenius : std::nullopt;
  if (!relative || !pupil.real_semi_axes_arcmin) return std::nullopt;
  const auto& [major, minor] = *pupil.real_semi_axes_arcmin;
  if (!major || !minor) return std::nullopt;
  return *relative * 0.25 * std::hypot(*major * *major, *minor * *minor);
}

std::string rows_of(const LensStudyView& view, std::optional<MethodError> LensPupil::*method) {
  std::string rows;
  for (const LensPupil& pupil : view.pupils) {
    const Number error = absolute_error(pupil, method);
    if (error && pupil.pupil_mm && *error > 0.0)
      rows += plain_number(*pupil.pupil_mm, 9) + " " + plain_number(*error, 9) + "\n";
  }
  return rows;
}

/// The oblique view of a lens in which ray transfer errs most at the smallest pupil; null if there is none.
const LensStudyView* worst_view(const LensFindings& found, const std::string& lens) {
  const LensStudyView* worst = nullptr;
  double largest = 0.0;
  for (const LensStudyView& view : found.views) {
    if (view.lens != lens || view.pupils.empty() || !(view.eccentricity_deg.value_or(0.0) > 0.0)) continue;
    const double error = absolute_error(view.pupils.front(), &LensPupil::ray_transfer).value_or(0.0);
    if (error > largest) {
      largest = error;
      worst = &view;
    }
  }
  return worst;
}

double published_error(const LensStudyView& view) {
  return defocus_of(view.first_order.published).value_or(0.0);
}

constexpr const char* colours[] = {"#08519c", "#3182bd", "#6baed6", "#238b45", "#74c476", "#54278f",
                                   "#9e9ac8", "#d94801", "#fd8d3c", "#636363", "#969696", "#000000"};

}  // namespace

std::optional<Figure> convergence_figure(const LensFindings& found) {
  std::string blocks, plots, guide_anchor;
  std::size_t count = 0;
  const auto add = [&](const std::string& rows, const std::string& look, const std::string& title) {
    if (rows.empty()) return;
    const std::string name = "$series" + std::to_string(++count);
    blocks += name + " << END\n" + rows + "END\n";
    plots += (plots.empty() ? "plot " : ", ") + name + " with linespoints " + look + " title \"" + title + "\"";
  };
  std::size_t number = 0;
  const LensStudyView* shown = nullptr;  // the view in which eq. 11 errs most
  double largest_published = 0.0;
  for (const LensFacts& lens : found.lenses) {
    const LensStudyView* view = worst_view(found, lens.id);
    if (!view) continue;
    const double published = published_error(*view);
    if (!shown || published > largest_published) {
      shown = view;
      largest_published = published;
    }
    const char* colour = colours[number++ % std::size(colours)];
    add(rows_of(*view, &LensPupil::ray_transfer), std::string("pt 7 ps 0.5 lw 1.6 lc rgb '") + colour + "'", lens.id);
  }
  if (!shown) return std::nullopt;
  add(rows_of(*shown, &LensPupil::published), "pt 5 ps 0.6 lw 1.6 dt 2 lc rgb '#b2182b'",
      "as published, " + shown->lens);
  add(rows_of(*shown, &LensPupil::previous), "pt 9 ps 0.7 lw 1.6 dt 3 lc rgb '#b8860b'", "previous, " + shown->lens);
  const double start = absolute_error(shown->pupils.front(), &LensPupil::ray_transfer).value_or(1e-6),
               pupil = shown->pupils.front().pupil_mm.value_or(1.0);
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
