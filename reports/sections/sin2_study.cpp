#include "compare/studies/sin2/shown_checks.h"
#include "compare/studies/sin2/sin2_findings.h"
#include "compare/studies/stored_words.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/plots/figure.h"
#include "reports/sections/sections.h"
#include "reports/sections/spreads.h"

namespace sturm {

namespace {

Html explanation(const Sin2Conditions& conditions) {
  return "<p>"_html + count_html(conditions.grid_eyes) + " constructed and "_html + count_html(conditions.real_eyes) +
         " real prescriptions, each at every distance, pupil and state; "_html + count_html(conditions.radial) +
         " × "_html + count_html(conditions.azimuthal) +
         R"( rays per case by quadrature. The error is the largest difference of the blur's half-width
from wavefront theory in any direction, divided by the pupil's radius: the defocus [D] that would blur as much. Closed forms are the check;
the numbers come from traced rays. With <i>V</i><sub>1</sub>, <i>V</i><sub>2</sub> the principal values of <i>I</i>/<i>d</i> + <i>F</i> − <i>A I</i>:</p>
<table class="formula"><tbody>
<tr><th scope="row">wavefront theory</th><td><i>a</i>|<i>V</i><sub>1</sub>|, <i>a</i>|<i>V</i><sub>2</sub>|</td></tr>
<tr><th scope="row">sin²</th><td><i>a</i>√((5<i>V</i><sub>1</sub>² + 2<i>V</i><sub>1</sub><i>V</i><sub>2</sub> + <i>V</i><sub>2</sub>²)/8),
<i>a</i>√((<i>V</i><sub>1</sub>² + 2<i>V</i><sub>1</sub><i>V</i><sub>2</sub> + 5<i>V</i><sub>2</sub>²)/8)</td></tr></tbody></table>
)"_html;
}

Html check_table(const Sin2StudyFindings& found) {
  HtmlTable table("What was measured, against what theory says of it", "compact",
                  {{"Quantity"_html, false}, {"Measured"_html}, {"Cases"_html}, {"Where"_html, false}});
  for (const ShownCheck& check : shown_checks) {
    const Sin2Check* entry = found.check(check.key);
    if (!entry || !entry->value) continue;
    table.add_row({text(check.what), number_html(entry->value, 3), count_html(entry->cases),
                   text_or_dash(entry->worst_case.value_or(""))});
  }
  return table.html();
}

Html model_table(const Sin2StudyFindings& found) {
  HtmlTable table("Cases and rays", "compact",
                  {{"Ray model"_html, false},
                   {"Cases"_html},
                   {"Undefined"_html},
                   {"Pole in the pupil"_html},
                   {"Rays"_html},
                   {"Dropped"_html},
                   {"Focus behind the eye"_html},
                   {"Largest error [D]"_html},
                   {"Where"_html, false}});
  for (const Sin2ModelRow& row : found.models)
    table.add_row({text_or_dash(row.title), count_html(row.cases), count_html(row.undefined), count_html(row.pole),
                   count_html(row.rays), count_html(row.rays_dropped), count_html(row.rays_negative_focus),
                   number_html(row.largest_error_D), text_or_dash(row.largest_error_case.value_or(""))});
  return table.html();
}

Html triple(const Distribution& d) {
  return number_html(d.median, 3) + " / "_html + number_html(d.p90, 3) + " / "_html + number_html(d.max, 3);
}

/// Everyone's worst view first, then view by view.
Html population_table(const Sin2StudyFindings& found, bool all_views) {
  HtmlTable table(all_views ? "Real eyes, view by view" : "Real eyes, each in its worst view", "sortable",
                  {{"Ray model"_html, false},
                   {"State"_html, false},
                   {"Target"_html},
                   {"Error [D]"_html},
                   {"Error [arcmin]"_html},
                   {"Error [%]"_html},
                   {"Above 0.25 D"_html},
                   {"Pole in the pupil"_html},
                   {"Eyes"_html}});
  for (const Sin2PopulationRow& row : found.population) {
    if (row.accommodation.has_value() != all_views) continue;
    const auto count = [](const Count& number) { return Cell(count_html(number), number); };
    table.add_row({text_or_dash(word_of(row.ray_model)),
                   all_views ? text_or_dash(*row.accommodation) : "any"_html,
                   all_views ? distance_html(row.distance_m) : "any"_html,
                   {triple(row.error_D), row.error_D.median},
                   {triple(row.error_arcmin), row.error_arcmin.median},
                   {triple(row.error_percent), row.error_percent.median},
                   count(row.noticeable),
                   count(row.pole),
                   count(row.eyes)});
  }
  return table.html();
}

Html gallery_table(const Sin2StudyFindings& found) {
  if (found.gallery.empty()) return {};
  HtmlTable table("Point-spread functions against wavefront theory", "compact",
                  {{"View"_html, false},
                   {"Model"_html, false},
                   {"Total variation"_html},
                   {"… over that of two runs of theory"_html},
                   {"Radius of 50 % [arcmin]"_html},
                   {"Radius of 80 % [arcmin]"_html}});
  for (const Sin2GalleryEntry& view : found.gallery)
    for (const Sin2Spread& psf : view.models)
      table.add_row({text_or_dash(view.title), text_or_dash(psf.model), number_html(psf.total_variation, 3),
                     number_html(psf.total_variation_over_noise, 3), number_html(psf.radius_50_arcmin),
                     number_html(psf.radius_80_arcmin)});
  return table.html();
}

/// The densities of the gallery, view by view; the first model of each is wavefront theory.
Html gallery_viewers(const Sin2StudyFindings& found, const std::filesystem::path& run_folder, ViewerPayload& payload) {
  std::vector<SpreadGroup> groups;
  for (const Sin2GalleryEntry& view : found.gallery) {
    SpreadGroup group;
    group.title = view.title;
    group.quantity = "share of the light per square arcminute";
    if (view.half_side_arcmin) group.side_arcmin = 2.0 * *view.half_side_arcmin;
    for (const Sin2Spread& psf : view.models) {
      const SpreadGroup::Spread spread{psf.model, psf.model, psf.file};
      if (psf.model == "wavefront")
        group.truth = spread;
      else
        group.spreads.push_back(spread);
    }
    groups.push_back(std::move(group));
  }
  const std::vector<Html> places = spread_viewers(groups, run_folder, payload);
  Html html;
  for (std::size_t i = 0; i < groups.size(); ++i)
    if (!places[i].empty()) html += element("article", element("h4", text_or_dash(groups[i].title)) + places[i]);
  return html.empty() ? Html() : folded("The densities, value by value"_html, html);
}

}  // namespace

Html sin2_study_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload) {
  const std::optional<Sin2StudyFindings> found = sin2_study_findings(report);
  if (!found) return {};
  Html html = element("h2", "What sin² does, and what it means"_html) + explanation(found->conditions) +
              check_table(*found) + model_table(*found);
  for (const Json& figure : figures_of(report, "sin2_study")) html += figure_html(figure, run_folder);
  html +=
      element("h3", "What it means for real eyes"_html) +
      element("p", "Median / 90 % / largest over the uncorrected eyes, pupil "_html +
                       exact_html(found->conditions.reference_pupil_mm) +
                       " mm. Eyes with the pole of the printed formula within the pupil have no error that could be "
                       "told; they are "
                       "counted apart. In percent: of the true major semi-axis."_html) +
      population_table(*found, false) + folded("View by view"_html, population_table(*found, true)) +
      gallery_table(*found) + gallery_viewers(*found, run_folder, payload);
  return element("section", {{"id", "sin2_study"}}, html);
}

}  // namespace sturm
