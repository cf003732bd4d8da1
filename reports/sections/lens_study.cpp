#include <algorithm>
#include <cmath>
#include <map>

#include "compare/studies/lens/lens_study_errors.h"
#include "compare/studies/lens/lens_study_views.h"
#include "io/json/stored.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/plots/figure.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

Html explanation(const LensStudyConditions& conditions) {
  return R"(<p>Real rays leave the pupil by wavefront theory and go through both surfaces by Snell's law; their covariance <i>C</i> is
compared with <i>a</i>²/4 <i>X X</i><sup>T</sup> of each method. The error falls into two parts:</p>
<table class="formula"><tbody>
<tr><th scope="row">first order</th><td>method − ray transfer</td><td>grows as <i>a</i>², stays at every pupil in dioptres</td></tr>
<tr><th scope="row">truncation</th><td>ray transfer − real rays</td><td>grows as <i>a</i>⁴, the lens's aberration</td></tr></tbody></table>
<p>Errors are the largest difference of the blur's half-width in any direction, in minutes of arc, or divided by the pupil's radius, in
dioptres. The previous method's scaling to the object is our reading of a paper that gives no formula for it; before that scaling it is
exact. Quadrature: )"_html +
         count_html(conditions.radial) + " rings of "_html + count_html(conditions.azimuthal) + " rays.</p>\n"_html;
}

/// A bound on the error; the table gives the smallest eccentricity at which it is exceeded.
struct Threshold {
  const char *title, *unit;
  double bound;
  std::optional<double> WorstError::*value;
};

constexpr Threshold thresholds[] = {
    {"Smallest gaze angle at which the error is above 0.05 D", "D", defocus_that_matters_D, &WorstError::defocus_D},
    {"Smallest gaze angle at which the error is above 1 arcmin", "arcmin", blur_that_matters_arcmin,
     &WorstError::half_width_arcmin}};

Cell threshold_cell(const LensStudyErrors& errors, const std::string& lens, const StudyMethod& method, double pupil,
                    const Threshold& t) {
  for (const double eccentricity : errors.eccentricities_deg()) {
    const auto value = errors.at(lens, method.key, eccentricity, pupil).*t.value;
    if (value && *value > t.bound) return {exact_html(eccentricity) + "°"_html, eccentricity};
  }
  return {errors.over_gazes(lens, method.key, pupil).without > 0 ? "never*"_html : "never"_html, 999.0};
}

std::vector<Column> pupil_columns(const LensStudyErrors& errors) {
  std::vector<Column> columns = {{"Lens"_html, false}, {"Method"_html, false}};
  for (const double pupil : errors.pupils_mm()) columns.push_back({exact_html(pupil) + " mm"_html});
  return columns;
}

Html threshold_table(const LensStudyErrors& errors, const Threshold& t) {
  HtmlTable table(std::string(t.title) + ", by pupil", "sortable", pupil_columns(errors));
  for (const std::string& lens : errors.lenses())
    for (const StudyMethod& method : study_methods) {
      std::vector<Cell> cells = {text(lens), text(method.name)};
      for (const double pupil : errors.pupils_mm()) cells.push_back(threshold_cell(errors, lens, method, pupil, t));
      table.add_row(cells);
    }
  return table.html() + element("p", "*: some views have no ellipse by this method, or lost rays at the rim."_html);
}

Html largest_table(const LensStudyErrors& errors) {
  std::vector<Column> columns = pupil_columns(errors);
  columns.push_back({"Largest where"_html, false});
  columns.push_back({"Views without ellipse"_html});
  HtmlTable table("Largest error against real rays over all gazes and distances [D], by pupil", "sortable", columns);
  for (const std::string& lens : errors.lenses())
    for (const StudyMethod& method : study_methods) {
      std::vector<Cell> cells = {text(lens), text(method.name)};
      WorstError worst;
      for (const double pupil : errors.pupils_mm()) {
        const WorstError here = errors.over_gazes(lens, method.key, pupil);
        cells.push_back({number_html(here.defocus_D, 2), here.defocus_D});
        if (here.defocus_D && (!worst.defocus_D || *here.defocus_D > *worst.defocus_D)) worst = here;
        worst.without = here.without;  // the widest pupil has the most
      }
      const std::size_t bar = worst.defocus_view.find('|');
      cells.push_back(text_or_dash(bar == std::string::npos ? "" : worst.defocus_view.substr(bar + 1)));
      cells.push_back(count_html(worst.without));
      table.add_row(cells);
    }
  return table.html();
}

struct Range {
  std::optional<double> low, high;
  void add(const std::optional<double>& value) {
    if (!value) return;
    low = std::min(*value, low.value_or(*value));
    high = std::max(*value, high.value_or(*value));
  }
  Html html() const { return low ? number_html(low, 4) + " … "_html + number_html(high, 4) : absent_html(); }
};

Html order_table(const LensFindings& found) {
  HtmlTable table("Real rays approach the first order of ray transfer: oblique gazes, orders in the pupil's diameter",
                  "sortable",
                  {{"Lens"_html, false},
                   {"What it is"_html, false},
                   {"Order of the absolute error (theory: 4)"_html},
                   {"Order of the relative error (theory: 2)"_html},
                   {"Extrapolated to the pupil 0, largest relative error"_html},
                   {"First-order error as published, largest [D]"_html},
                   {"First-order error of the previous method, largest [D]"_html}});
  for (const LensFacts& lens : found.lenses) {
    Range order, relative, limit, published, previous;
    for (const LensStudyView& view : found.views) {
      if (view.lens != lens.id) continue;
      const bool oblique = view.eccentricity_deg.value_or(0.0) > 0.0;
      const bool blurred = view.blur_D[0].value_or(0.0) >= least_blur_D;
      if (oblique) order.add(view.order);
      if (oblique && blurred) relative.add(view.relative_order);
      if (blurred) limit.add(view.limit_relative);
      published.add(defocus_of(view.first_order.published));
      previous.add(defocus_of(view.first_order.previous));
    }
    table.add_row({text(lens.id), text_or_dash(lens.note), order.html(), relative.html(), number_html(limit.high, 2),
                   number_html(published.high, 2), number_html(previous.high, 2)});
  }
  return table.html() +
         element("p", "Relative orders and the limit: views whose larger principal blur is at least "_html +
                          exact_html(least_blur_D) + " D; nearer to focus the first order has next to no width."_html);
}

Html eq11_table(const LensFindings& found) {
  constexpr const char* outcomes[] = {"free_axes", "singular", "negative", "no_length"};
  std::vector<Column> columns = {{"Gaze from the axis"_html}, {"Lines of sight"_html}, {"Chief ray lost"_html}};
  for (const Html& reading : {"axes along e′<sub>1</sub>"_html, "axes in the plane of incidence"_html})
    for (const char* outcome : {"free axes", "singular", "E′ not positive", "no length"})
      columns.push_back({text(outcome) + small_html(reading)});
  HtmlTable table(
      "Where conoid tracing as published has no ellipse, or free axes: lines of sight by reading of the tangent "
      "plane's axes",
      "compact", columns);
  std::map<double, std::map<std::string, int>> counts;
  for (const LensGaze& gaze : found.gazes) {
    auto& row = counts[gaze.eccentricity_deg.value_or(0.0)];
    ++row["all"];
    row["chief"] += gaze.status != "ok";
    if (!gaze.eq11) continue;
    ++row["principal/" + gaze.eq11->principal];
    ++row["incidence/" + gaze.eq11->incidence];
  }
  for (auto& [eccentricity, row] : counts) {
    std::vector<Cell> cells = {exact_html(eccentricity) + "°"_html, count_html(row["all"]), count_html(row["chief"])};
    for (const char* reading : {"principal/", "incidence/"})
      for (const char* outcome : outcomes) cells.push_back(count_html(row[std::string(reading) + outcome]));
    table.add_row(cells);
  }
  return table.html() + element("p",
                                "“Free axes”: the wave behind the lens is a plane or a sphere, without principal "
                                "directions for the ellipse to lie along; it "
                                "keeps "
                                "those that it had. A relaxed eye sends out such a wave on the axis of the lens that "
                                "corrects it. The other columns have no "
                                "ellipse."_html);
}

}  // namespace

Html lens_study_section(const Json& report, const std::filesystem::path& run_folder) {
  const std::optional<LensFindings> found = lens_findings(report);
  if (!found) return {};
  const LensStudyErrors errors(*found);
  Html plots, maps, tables;
  for (const Json& figure : figures_of(report, "lens_study"))
    (text_at(figure, "id").starts_with("lens_study_heat_") ? maps : plots) += figure_html(figure, run_folder);
  for (const Threshold& t : thresholds)
    tables += folded(text(t.title) + ", by lens, method and pupil"_html, threshold_table(errors, t), true);
  if (!maps.empty()) maps = folded("Error by gaze and pupil, one map per lens"_html, maps, true);
  const Html html = element("h2", "Conoid tracing through spectacles against real rays"_html) +
                    explanation(found->conditions) + largest_table(errors) + tables + maps + order_table(*found) +
                    eq11_table(*found) + plots;
  return element("section", {{"id", "lens_study"}}, html);
}

}  // namespace sturm
