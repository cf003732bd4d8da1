#include <nlohmann/json.hpp>

#include "compare/studies/sin2/shown_checks.h"
#include "io/json/stored.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/plots/figure.h"
#include "reports/sections/sections.h"
#include "reports/sections/spreads.h"

namespace sturm {

namespace {

Html explanation(const Json& conditions) {
  const auto count = [&](const char* key) { return count_html(number_at(conditions, key)); };
  return "<p>"_html + count("grid_eyes") + " constructed and "_html + count("real_eyes") +
         " real prescriptions, each at every distance, pupil and state; "_html + count("radial") + " × "_html +
         count("azimuthal") +
         R"( rays per case by quadrature. The error is the largest difference of the blur's half-width
from wavefront theory in any direction, divided by the pupil's radius: the defocus [D] that would blur as much. Closed forms are the check;
the numbers come from traced rays. With <i>V</i><sub>1</sub>, <i>V</i><sub>2</sub> the principal values of <i>I</i>/<i>d</i> + <i>F</i> − <i>A I</i>:</p>
<table class="formula"><tbody>
<tr><th scope="row">wavefront theory</th><td><i>a</i>|<i>V</i><sub>1</sub>|, <i>a</i>|<i>V</i><sub>2</sub>|</td></tr>
<tr><th scope="row">sin²</th><td><i>a</i>√((5<i>V</i><sub>1</sub>² + 2<i>V</i><sub>1</sub><i>V</i><sub>2</sub> + <i>V</i><sub>2</sub>²)/8),
<i>a</i>√((<i>V</i><sub>1</sub>² + 2<i>V</i><sub>1</sub><i>V</i><sub>2</sub> + 5<i>V</i><sub>2</sub>²)/8)</td></tr></tbody></table>
)"_html;
}

Html check_table(const Json& section) {
  HtmlTable table("What was measured, against what theory says of it", "compact",
                  {{"Quantity"_html, false}, {"Measured"_html}, {"Cases"_html}, {"Where"_html, false}});
  for (const ShownCheck& check : shown_checks) {
    const Json& entry = value_at(section, std::string("checks/") + check.key);
    if (!number_at(entry, "value")) continue;
    table.add_row({text(check.what), number_html(number_at(entry, "value"), 3), count_html(number_at(entry, "cases")),
                   text_or_dash(text_at(entry, "worst_case"))});
  }
  return table.html();
}

Html model_table(const Json& section) {
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
  for (const Json& row : array_at(section, "models")) {
    const auto count = [&](const char* key) { return count_html(number_at(row, key)); };
    table.add_row({text_or_dash(text_at(row, "title")), count("cases"), count("undefined"), count("pole"),
                   count("rays"), count("rays_dropped"), count("rays_negative_focus"),
                   number_html(number_at(row, "largest_error_D")), text_or_dash(text_at(row, "largest_error_case"))});
  }
  return table.html();
}

Html triple(const Json& row, const char* key) {
  Html html;
  for (const char* rank : {"median", "p90", "max"})
    add_item(html, number_html(number_at(row, std::string(key) + "/" + rank), 3), " / "_html);
  return html;
}

/// Everyone's worst view first, then view by view.
Html population_table(const Json& section, bool all_views) {
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
  for (const Json& row : array_at(section, "population")) {
    if (value_at(row, "accommodation").is_null() == all_views) continue;
    const auto count = [&](const char* key) { return Cell(count_html(number_at(row, key)), number_at(row, key)); };
    table.add_row({text_or_dash(text_at(row, "ray_model")),
                   all_views ? text_or_dash(text_at(row, "accommodation")) : "any"_html,
                   all_views ? distance_html(value_at(row, "distance_m")) : "any"_html,
                   {triple(row, "error_D"), number_at(row, "error_D/median")},
                   {triple(row, "error_arcmin"), number_at(row, "error_arcmin/median")},
                   {triple(row, "error_percent"), number_at(row, "error_percent/median")},
                   count("noticeable"),
                   count("pole"),
                   count("eyes")});
  }
  return table.html();
}

Html gallery_table(const Json& section) {
  if (array_at(section, "gallery").empty()) return {};
  HtmlTable table("Point-spread functions against wavefront theory", "compact",
                  {{"View"_html, false},
                   {"Model"_html, false},
                   {"Total variation"_html},
                   {"… over that of two runs of theory"_html},
                   {"Radius of 50 % [arcmin]"_html},
                   {"Radius of 80 % [arcmin]"_html}});
  for (const Json& view : array_at(section, "gallery"))
    for (const Json& psf : array_at(view, "models"))
      table.add_row({text_or_dash(text_at(view, "title")), text_or_dash(text_at(psf, "model")),
                     number_html(number_at(psf, "total_variation"), 3),
                     number_html(number_at(psf, "total_variation_over_noise"), 3),
                     number_html(number_at(psf, "radius_50_arcmin")), number_html(number_at(psf, "radius_80_arcmin"))});
  return table.html();
}

/// The densities of the gallery, view by view; the first model of each is wavefront theory.
Html gallery_viewers(const Json& section, const std::filesystem::path& run_folder, ViewerPayload& payload) {
  std::vector<SpreadGroup> groups;
  for (const Json& view : array_at(section, "gallery")) {
    SpreadGroup group;
    group.title = text_at(view, "title");
    group.quantity = "share of the light per square arcminute";
    if (const auto half = number_at(view, "half_side_arcmin")) group.side_arcmin = 2.0 * *half;
    for (const Json& psf : array_at(view, "models")) {
      const std::string model = text_at(psf, "model");
      const SpreadGroup::Spread spread{model, model, text_at(psf, "file")};
      if (model == "wavefront")
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
  const Json& section = value_at(report, "sin2_study");
  if (!section.is_object()) return {};
  Html html = element("h2", "What sin² does, and what it means"_html) + explanation(value_at(section, "conditions")) +
              check_table(section) + model_table(section);
  for (const Json& figure : figures_of(report, "sin2_study")) html += figure_html(figure, run_folder);
  html +=
      element("h3", "What it means for real eyes"_html) +
      element("p", "Median / 90 % / largest over the uncorrected eyes, pupil "_html +
                       exact_html(number_at(section, "conditions/reference_pupil_mm")) +
                       " mm. Eyes with the pole of the printed formula within the pupil have no error that could be "
                       "told; they are "
                       "counted apart. In percent: of the true major semi-axis."_html) +
      population_table(section, false) + folded("View by view"_html, population_table(section, true)) +
      gallery_table(section) + gallery_viewers(section, run_folder, payload);
  return element("section", {{"id", "sin2_study"}}, html);
}

}  // namespace sturm
