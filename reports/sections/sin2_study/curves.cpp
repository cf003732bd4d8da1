#include <algorithm>

#include "io/files/formatted_text.h"
#include "reports/plots/gnuplot.h"
#include "reports/plots/plot_style.h"
#include "reports/sections/sin2_study/figures.h"

namespace sturm {

namespace {

constexpr const char* style = R"(
set border 3 lc rgb '#666666'
set tics nomirror out
set grid lc rgb '#e4e4e4' lw 1 lt 1
)";

struct Series {
  RayModel model;
  const char *title, *colour, *points;
};
constexpr Series series[] = {{RayModel::sin2_radial, "sin² rays", "#2166ac", "pt 6 ps 0.9"},
                             {RayModel::metalstigmatism, "focal distances added", "#b2182b", "pt 2 ps 0.9"}};

/// The entry of a model; an empty one if there is none.
template <class Entry>
Entry of_model(const std::vector<Entry>& list, RayModel model) {
  for (const Entry& entry : list)
    if (entry.ray_model == model) return entry;
  return {};
}

std::string row(double x, double y) {
  return plain_number(x, 9) + " " + plain_number(y, 9) + "\n";
}

/// `column`: 1 is wavefront theory, 2 the model.
std::string curve_rows(const Sin2StudyFindings& found, RayModel model, std::size_t column) {
  std::string rows;
  const Sin2Curve curve = of_model(found.reference_view.curves, model);
  for (const std::array<Number, 3>& point : curve.points)
    if (point[0] && point[column]) rows += row(*point[0], *point[column]);
  return rows;
}

/// Share of the eyes [%] with an error above x, as steps.
std::string exceedance_rows(const std::vector<Number>& errors, double eyes) {
  std::string rows;
  double above = static_cast<double>(errors.size());
  for (const Number& value : errors) {
    if (!value) continue;
    if (*value > 0.0) rows += row(*value, 100.0 * above / eyes);
    above -= 1.0;
    if (*value > 0.0) rows += row(*value, 100.0 * above / eyes);
  }
  return rows;
}

std::string view_text(const Sin2StudyFindings& found) {
  const Number distance = finite(found.conditions.reference_distance_m);
  return distance ? plain_number(*distance) + " m" : "infinity";
}

}  // namespace

std::optional<Figure> sin2_sphere_curves(const Sin2StudyFindings& found) {
  const std::string truth = curve_rows(found, RayModel::power_matrix, 1);
  if (truth.empty()) return std::nullopt;
  std::string blocks = data_block("truth", truth),
              plots = "plot $truth with lines lw 2 lc rgb '#333333' title 'wavefront theory'";
  for (const Series& s : series) {
    const std::string rows = curve_rows(found, s.model, 2);
    if (rows.empty()) continue;
    blocks += data_block(name_of(s.model), rows);
    plots += ", $" + name_of(s.model) + " with points " + s.points + " lw 1.5 lc rgb '" + s.colour + "' title '" +
             s.title + ", traced'";
  }
  Figure figure;
  figure.id = "sin2_study_sphere";
  figure.section = "sin2_study";
  figure.title = "Blur against the sphere, without a cylinder";
  figure.caption = "Target and focus at " + view_text(found) + ", pupil " +
                   plain_number(found.conditions.reference_pupil_mm.value_or(0.0)) +
                   " mm. With focal distances added blur shrinks as the prescription grows; without a prescription the "
                   "eye is focused at "
                   "infinity; at P = −1/d_f there is a pole (no point).";
  figure.svg =
      gnuplot_file(std::string(style) +
                       "set xlabel 'sphere [D]'\nset ylabel 'semi-axis of the blur [arcmin]'\nset yrange [0:*]\n"
                       "set key top center Left reverse samplen 2 spacing 1.3\n" +
                       blocks + plots,
                   {.id = figure.id, .label = figure.title, .width = 1120, .height = 430});
  return figure;
}

std::optional<Figure> sin2_population_curves(const Sin2StudyFindings& found) {
  const double eyes = Number(found.conditions.real_eyes).value_or(0.0);
  if (!(eyes > 0.0)) return std::nullopt;
  std::string blocks, plots;
  for (const Series& s : series) {
    const std::string rows = exceedance_rows(of_model(found.reference_view.cumulative, s.model).error_D, eyes);
    if (rows.empty()) continue;
    blocks += data_block(name_of(s.model), rows);
    plots += (plots.empty() ? "plot $" : ", $") + name_of(s.model) + " with lines lw 2 lc rgb '" + s.colour +
             "' title '" + s.title + "'";
  }
  if (plots.empty()) return std::nullopt;
  Figure figure;
  figure.id = "sin2_study_population";
  figure.section = "sin2_study";
  figure.title = "Real eyes: how many see an error above …";
  figure.caption = plain_number(eyes) + " prescriptions, uncorrected, target and focus at " + view_text(found) +
                   ". Dashed: 0.25 D, the step in which lenses come. Eyes with the pole within their pupil have no "
                   "error that could be "
                   "told, and are missing from the curve's height on the left.";
  figure.svg = gnuplot_file(std::string(style) + R"(
set logscale x
set xrange [0.005:20]
set yrange [0:100]
set xlabel 'error of the half-width over the radius of the pupil [D]'
set ylabel 'share of the eyes [%]'
set key bottom left Left reverse samplen 2 spacing 1.3 opaque
set arrow from 0.25, graph 0 to 0.25, graph 1 nohead dt 2 lw 1.5 lc rgb '#333333'
)" + blocks + plots,
                            {.id = figure.id, .label = figure.title, .width = 1120, .height = 430});
  return figure;
}

}  // namespace sturm
