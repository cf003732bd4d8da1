#include "compare/studies/designs/design_findings.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/plots/figure.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

Number in_percent(const Number& share) {
  return share ? Number(100.0 * *share) : std::nullopt;
}

Html explanation(const DesignConditions& conditions) {
  return element(
      "p",
      "Each design is made for its own prescription and worn by the eye that it corrects, which turns about a "
      "point "_html +
          exact_html(conditions.rotation_center_mm) +
          " mm behind its pupil. A place of the lens is clear where the larger principal value of its error "
          "is at most "_html +
          exact_html(conditions.clear_D) + " D."_html);
}

Html design_table(const DesignFindings& found) {
  HtmlTable table("The designs as worn", "sortable",
                  {{"Design"_html, false},
                   {"What it is"_html, false},
                   {"Made for: sphere [D]"_html},
                   {"cylinder [D]"_html},
                   {"axis [°]"_html},
                   {"Largest mean error [D]"_html},
                   {"Largest cylinder of the error [D]"_html},
                   {"Clear area [%]"_html},
                   {"Corridor: least width [°]"_html},
                   {"at a gaze up [°]"_html}});
  for (const DesignFacts& design : found.designs)
    table.add_row({text(design.id),
                   text_or_dash(design.note),
                   {number_html(design.sphere_D, 3), design.sphere_D},
                   {number_html(design.cylinder_D, 3), design.cylinder_D},
                   {number_html(design.axis_deg, 3), design.axis_deg},
                   {number_html(design.largest_mean_D, 3), design.largest_mean_D},
                   {number_html(design.largest_cylinder_D, 3), design.largest_cylinder_D},
                   {number_html(design.clear_area_percent, 3), design.clear_area_percent},
                   {exact_html(design.narrowest_deg), design.narrowest_deg},
                   {exact_html(design.narrowest_elevation_deg), design.narrowest_elevation_deg}});
  return table.html();
}

Html summary_table(const DesignFindings& found) {
  HtmlTable table("The population: share of the gazes that are blurred by more than the bound", "sortable",
                  {{"Design"_html, false},
                   {"Target [m]"_html},
                   {"Wearers"_html},
                   {"Cannot be made for"_html},
                   {"Blurred gazes, median wearer [%]"_html},
                   {"nine in ten have at most [%]"_html},
                   {"Defocus, median of medians [D]"_html}});
  for (const DesignSummary& s : design_summaries(found))
    table.add_row({text(s.design),
                   {distance_html(s.distance_m), s.distance_m ? Number(s.distance_m->metres) : std::nullopt},
                   count_html(static_cast<double>(s.wearers)),
                   count_html(static_cast<double>(s.not_made)),
                   {number_html(in_percent(s.median_share), 3), s.median_share},
                   {number_html(in_percent(s.ninth_decile_share), 3), s.ninth_decile_share},
                   {number_html(s.median_D, 3), s.median_D}});
  return table.html();
}

Html wearer_table_html(const DesignFindings& found) {
  HtmlTable table("Every wearer", "sortable filterable",
                  {{"Wearer"_html, false},
                   {"Design"_html, false},
                   {"Target [m]"_html},
                   {"Sphere [D]"_html},
                   {"Cylinder [D]"_html},
                   {"Age"_html},
                   {"Accommodation [D]"_html},
                   {"Addition [D]"_html},
                   {"Blurred gazes [%]"_html},
                   {"Median [D]"_html},
                   {"Largest [D]"_html},
                   {"Status"_html, false}});
  for (const DesignWearer& row : found.wearers)
    table.add_row({text(row.wearer),
                   text(row.design),
                   {distance_html(row.distance_m), row.distance_m ? Number(row.distance_m->metres) : std::nullopt},
                   {exact_html(row.sphere_D), row.sphere_D},
                   {exact_html(row.cylinder_D), row.cylinder_D},
                   {exact_html(row.age_years), row.age_years},
                   {number_html(row.amplitude_D, 3), row.amplitude_D},
                   {exact_html(row.addition_D), row.addition_D},
                   {number_html(in_percent(row.share_blurred), 3), row.share_blurred},
                   {number_html(row.median_D, 3), row.median_D},
                   {number_html(row.largest_D, 3), row.largest_D},
                   text_or_dash(row.status)});
  return table.html();
}

Html population(const DesignFindings& found) {
  if (found.wearers.empty()) return {};
  const Html words =
      "Each design is made anew for each wearer, with the wearer's own addition where the table states one. The "
      "wearer, who accommodates as far as the age allows, looks in all directions up to "_html +
      exact_html(found.conditions.reach_deg) + "° in steps of "_html + exact_html(found.conditions.step_deg) +
      "°. A gaze is blurred where the larger principal value of the defocus is above "_html +
      exact_html(found.conditions.clear_D) + " D. "_html + file_link("design_study.csv") + " has every row."_html;
  return element("p", words) + summary_table(found) + folded("Every wearer"_html, wearer_table_html(found));
}

}  // namespace

Html design_study_section(const Json& report, const std::filesystem::path& run_folder) {
  const std::optional<DesignFindings> found = design_findings(report);
  if (!found) return {};
  Html html = element("h2", "Lens designs"_html) + explanation(found->conditions) + design_table(*found);
  for (const Json& figure : figures_of(report, "design_study")) html += figure_html(figure, run_folder);
  return element("section", {{"id", "design_study"}}, html + population(*found));
}

}  // namespace sturm
