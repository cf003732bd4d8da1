#include <nlohmann/json.hpp>

#include "compare/studies/sin2/shown_checks.h"
#include "io/json/stored.h"
#include "reports/markup/markup.h"
#include "reports/markup/numbers.h"
#include "reports/plots/figure.h"
#include "reports/sections/sections.h"
#include "reports/sections/spreads.h"

namespace sturm {

namespace {

std::string explanation(const Json& conditions) {
  const auto count = [&](const char* key) { return count_html(number_at(conditions, key)); };
  return "<p>" + count("grid_eyes") + " constructed and " + count("real_eyes") +
         " real prescriptions, each at every distance, pupil and state; " + count("radial") + " × " +
         count("azimuthal") +
         R"( rays per case by quadrature. The error is the largest difference of the blur's half-width
from wavefront theory in any direction, divided by the pupil's radius: the defocus [D] that would blur as much. Closed forms are the check;
the numbers come from traced rays. With <i>V</i><sub>1</sub>, <i>V</i><sub>2</sub> the principal values of <i>I</i>/<i>d</i> + <i>F</i> − <i>A I</i>:</p>
<table class="formula"><tbody>
<tr><th scope="row">wavefront theory</th><td><i>a</i>|<i>V</i><sub>1</sub>|, <i>a</i>|<i>V</i><sub>2</sub>|</td></tr>
<tr><th scope="row">sin²</th><td><i>a</i>√((5<i>V</i><sub>1</sub>² + 2<i>V</i><sub>1</sub><i>V</i><sub>2</sub> + <i>V</i><sub>2</sub>²)/8),
<i>a</i>√((<i>V</i><sub>1</sub>² + 2<i>V</i><sub>1</sub><i>V</i><sub>2</sub> + 5<i>V</i><sub>2</sub>²)/8)</td></tr></tbody></table>
)";
}

std::string check_table(const Json& section) {
  HtmlTable table("What was measured, against what theory says of it", "compact",
                  {{"Quantity", false}, {"Measured"}, {"Cases"}, {"Where", false}});
  for (const ShownCheck& check : shown_checks) {
    const Json& entry = value_at(section, std::string("checks/") + check.key);
    if (!number_at(entry, "value")) continue;
    table.add_row({check.what, number_html(number_at(entry, "value"), 3), count_html(number_at(entry, "cases")),
                   text_html(text_at(entry, "worst_case"))});
  }
  return table.html();
}

std::string model_table(const Json& section) {
  HtmlTable table("Cases and rays", "compact",
                  {{"Ray model", false},
                   {"Cases"},
                   {"Undefined"},
                   {"Pole in the pupil"},
                   {"Rays"},
                   {"Dropped"},
                   {"Focus behind the eye"},
                   {"Largest error [D]"},
                   {"Where", false}});
  for (const Json& row : array_at(section, "models")) {
    const auto count = [&](const char* key) { return count_html(number_at(row, key)); };
    table.add_row({text_html(text_at(row, "title")), count("cases"), count("undefined"), count("pole"), count("rays"),
                   count("rays_dropped"), count("rays_negative_focus"), number_html(number_at(row, "largest_error_D")),
                   text_html(text_at(row, "largest_error_case"))});
  }
  return table.html();
}

std::string triple(const Json& row, const char* key) {
  std::string html;
  for (const char* rank : {"median", "p90", "max"})
    html += (html.empty() ? "" : " / ") + number_html(number_at(row, std::string(key) + "/" + rank), 3);
  return html;
}

/// Everyone's worst view first, then view by view.
std::string population_table(const Json& section, bool all_views) {
  HtmlTable table(all_views ? "Real eyes, view by view" : "Real eyes, each in its worst view", "sortable",
                  {{"Ray model", false},
                   {"State", false},
                   {"Target"},
                   {"Error [D]"},
                   {"Error [arcmin]"},
                   {"Error [%]"},
                   {"Above 0.25 D"},
                   {"Pole in the pupil"},
                   {"Eyes"}});
  for (const Json& row : array_at(section, "population")) {
    if (value_at(row, "accommodation").is_null() == all_views) continue;
    const auto count = [&](const char* key) { return Cell(count_html(number_at(row, key)), number_at(row, key)); };
    table.add_row({text_html(text_at(row, "ray_model")),
                   all_views ? text_html(text_at(row, "accommodation")) : "any",
                   all_views ? distance_html(value_at(row, "distance_m")) : "any",
                   {triple(row, "error_D"), number_at(row, "error_D/median")},
                   {triple(row, "error_arcmin"), number_at(row, "error_arcmin/median")},
                   {triple(row, "error_percent"), number_at(row, "error_percent/median")},
                   count("noticeable"),
                   count("pole"),
                   count("eyes")});
  }
  return table.html();
}

std::string gallery_table(const Json& section) {
  if (array_at(section, "gallery").empty()) return "";
  HtmlTable table("Point-spread functions against wavefront theory", "compact",
                  {{"View", false},
                   {"Model", false},
                   {"Total variation"},
                   {"… over that of two runs of theory"},
                   {"Radius of 50 % [arcmin]"},
                   {"Radius of 80 % [arcmin]"}});
  for (const Json& view : array_at(section, "gallery"))
    for (const Json& psf : array_at(view, "models"))
      table.add_row({text_html(text_at(view, "title")), text_html(text_at(psf, "model")),
                     number_html(number_at(psf, "total_variation"), 3),
                     number_html(number_at(psf, "total_variation_over_noise"), 3),
                     number_html(number_at(psf, "radius_50_arcmin")), number_html(number_at(psf, "radius_80_arcmin"))});
  return table.html();
}

/// The densities of the gallery, view by view; the first model of each is wavefront theory.
std::string gallery_viewers(const Json& section, const std::filesystem::path& run_folder, ViewerPayload& payload) {
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
  const std::vector<std::string> places = spread_viewers(groups, run_folder, payload);
  std::string html;
  for (std::size_t i = 0; i < groups.size(); ++i)
    if (!places[i].empty()) html += element("article", "", element("h4", "", text_html(groups[i].title)) + places[i]);
  return html.empty() ? "" : folded("The densities, value by value", html);
}

}  // namespace

std::string sin2_study_section(const Json& report, const std::filesystem::path& run_folder, ViewerPayload& payload) {
  const Json& section = value_at(report, "sin2_study");
  if (!section.is_object()) return "";
  std::string html = element("h2", "", "What sin² does, and what it means") +
                     explanation(value_at(section, "conditions")) + check_table(section) + model_table(section);
  for (const Json& figure : figures_of(report, "sin2_study")) html += figure_html(figure, run_folder);
  html += element("h3", "", "What it means for real eyes") +
          element("p", "",
                  "Median / 90 % / largest over the uncorrected eyes, pupil " +
                      exact_html(number_at(section, "conditions/reference_pupil_mm")) +
                      " mm. Eyes with the pole of the printed formula within the pupil have no error that could be "
                      "told; they are "
                      "counted apart. In percent: of the true major semi-axis.") +
          population_table(section, false) + folded("View by view", population_table(section, true)) +
          gallery_table(section) + gallery_viewers(section, run_folder, payload);
  return element("section", "id=\"sin2_study\"", html);
}

}  // namespace sturm
