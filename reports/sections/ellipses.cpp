#include "compare/findings/ellipses.h"

#include <algorithm>
#include <map>
#include <vector>

#include "compare/findings/reference.h"
#include "compare/statistics/median.h"
#include "io/json/stored_values.h"
#include "lensmodel/units.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

struct Row {
  const EllipseFinding* item;  ///< the case
  const RayFinding* rays;      ///< one ray model of it
};

/// The rows of one ray model.
struct Group {
  std::optional<RayModel> model;
  std::vector<Row> rows;
};

std::string_view what_it_is(const std::optional<RayModel>& model) {
  static const std::map<RayModel, std::string_view> models = {
      {RayModel::pinhole, "the chief ray: no blur"},
      {RayModel::thin_lens, "depth of field with the spherical equivalent"},
      {RayModel::metalstigmatism, "sin² with focal distances added, as printed"},
      {RayModel::sin2_radial, "sin² with vergences added"},
      {RayModel::power_matrix, "wavefront theory to second order"}};
  const auto found = model ? models.find(*model) : models.end();
  return found == models.end() ? std::string_view() : found->second;
}

bool undefined(const RayFinding& rays) {
  return rays.status != RayStatus::Ok;
}

/// Worst first: without a result, then by the largest |z|, then by the relative difference.
bool worse(const Row& a, const Row& b) {
  if (undefined(*a.rays) != undefined(*b.rays)) return undefined(*a.rays);
  const EllipseAgreement of_a = a.rays->own_agreement(), of_b = b.rays->own_agreement();
  if (of_a.z_max != of_b.z_max) return of_a.z_max > of_b.z_max;
  return of_a.relative_frobenius > of_b.relative_frobenius;
}

/// The models that the project asks about come first.
int reading_order(const std::optional<RayModel>& model) {
  return model == RayModel::power_matrix ? 0 : model == RayModel::sin2_radial ? 1 : 2;
}

/// Rows by ray model, worst first.
std::vector<Group> by_ray_model(const std::vector<EllipseFinding>& cases) {
  std::vector<Group> groups;
  for (const EllipseFinding& item : cases) {
    for (const RayFinding& rays : item.rays) {
      auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.model == rays.model; });
      if (group == groups.end()) group = groups.insert(groups.end(), {rays.model, {}});
      group->rows.push_back({&item, &rays});
    }
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return reading_order(a.model) < reading_order(b.model); });
  for (Group& group : groups) std::stable_sort(group.rows.begin(), group.rows.end(), worse);
  return groups;
}

/// Of the rays against the conoid; without numbers where they were not compared.
ConoidComparison with_conoid(const RayFinding& rays) {
  return rays.against_conoid.value_or(ConoidComparison{});
}

EllipseAgreement with_closed_form(const RayFinding& rays) {
  return rays.against_closed_form.value_or(EllipseAgreement{});
}

/// Those of one number of each row that are there.
template <class NumberOf>
std::vector<double> sorted_numbers(const std::vector<Row>& rows, const NumberOf& number_of) {
  std::vector<double> numbers;
  for (const Row& row : rows) {
    if (const Number number = number_of(*row.rays)) numbers.push_back(*number);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

std::optional<double> largest(const std::vector<double>& sorted) {
  return sorted.empty() ? std::nullopt : std::optional(sorted.back());
}

Html summary_table(const std::vector<Group>& groups) {
  HtmlTable table("Ray models against the conoid, over all cases", "",
                  {{"Ray model"_html, false},
                   {"What it is"_html, false},
                   {"Cases"_html},
                   {"Without result"_html},
                   {"Relative difference from the conoid, median"_html},
                   {"Relative difference from the conoid, largest"_html},
                   {"Largest |z| from the conoid [σ]"_html},
                   {"Largest |z| from its closed form [σ]"_html}});
  for (const auto& [model, rows] : groups) {
    const auto without = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return undefined(*row.rays); });
    const auto differences =
        sorted_numbers(rows, [](const RayFinding& r) { return with_conoid(r).agreement.relative_frobenius; });
    const auto z = sorted_numbers(rows, [](const RayFinding& r) { return with_conoid(r).agreement.z_max; });
    const auto z_form = sorted_numbers(rows, [](const RayFinding& r) { return with_closed_form(r).z_max; });
    table.add_row({code_html(name_of(model)), text(what_it_is(model)), count_html(static_cast<double>(rows.size())),
                   count_html(static_cast<double>(without)), number_html(median(differences), 3),
                   number_html(largest(differences), 3), number_html(largest(z), 3), number_html(largest(z_form), 3)});
  }
  return table.html();
}

Cell semi_axes_cell(const std::optional<Ellipse>& e) {
  if (!e) return absent_html();
  const double major = e->semi_major * arcminutes_per_radian, minor = e->semi_minor * arcminutes_per_radian;
  return {number_html(major) + " × "_html + number_html(minor), e->semi_major};
}

Html status_html(const RayFinding& rays) {
  Html html = text_or_dash(rays.status ? ray_status_words.word_of(*rays.status) : "");
  const RayCounts counts = rays.counts.value_or(RayCounts{});
  for (const auto& [count, name] :
       {std::pair(counts.dropped, "dropped"), std::pair(counts.negative_focus, "with negative focus")})
    if (count > 0) html += small_html(count_html(static_cast<double>(count)) + " "_html + text(name));
  return html;
}

Cell sortable(std::optional<double> value, int significant) {
  return {number_html(value, significant), value};
}

Cell orientation_cell(const std::optional<Ellipse>& e) {
  return sortable(e ? e->orientation_deg : std::nullopt, 3);
}

Html case_table(const std::string& model, const std::vector<Row>& rows) {
  const bool closed_form =
      std::any_of(rows.begin(), rows.end(), [](const Row& r) { return r.rays->against_closed_form.has_value(); });
  std::vector<Column> columns = {{"Case"_html, false},
                                 {"Conoid, semi-axes [arcmin]"_html},
                                 {"Conoid, orientation [°]"_html},
                                 {"Rays, semi-axes [arcmin]"_html},
                                 {"Rays, orientation [°]"_html},
                                 {"Relative difference"_html},
                                 {"Largest |z| [σ]"_html},
                                 {"Minor-axis error [arcmin]"_html},
                                 {"Orientation error [°]"_html},
                                 {"Bures–Wasserstein [arcmin]"_html}};
  if (closed_form)
    columns.insert(columns.end(),
                   {{"Relative difference from closed form"_html}, {"Largest |z| from closed form [σ]"_html}});
  columns.push_back({"Status"_html, false});
  HtmlTable table("Ellipses of " + model + " rays against the conoid, worst first", "sortable filterable", columns);
  for (const Row& row : rows) {
    const EllipseFinding& item = *row.item;
    const RayFinding& rays = *row.rays;
    const ConoidComparison conoid = with_conoid(rays);
    std::vector<Cell> cells = {text_or_dash(item.id),
                               semi_axes_cell(item.conoid.ellipse),
                               orientation_cell(item.conoid.ellipse),
                               semi_axes_cell(rays.ellipse),
                               orientation_cell(rays.ellipse),
                               sortable(conoid.agreement.relative_frobenius, 3),
                               sortable(conoid.agreement.z_max, 3),
                               sortable(conoid.minor_axis_error_arcmin, 2),
                               sortable(conoid.orientation_error_deg, 2),
                               sortable(conoid.bures_wasserstein_arcmin, 2)};
    if (closed_form) {
      const EllipseAgreement form = with_closed_form(rays);
      cells.push_back(sortable(form.relative_frobenius, 3));
      cells.push_back(sortable(form.z_max, 3));
    }
    cells.push_back(status_html(rays));
    table.add_row(cells, undefined(rays) ? "fail" : "");
  }
  return table.html();
}

Html reference_table(const ReferenceFinding& reference) {
  if (reference.max_relative_error.empty()) return {};
  HtmlTable table("Conoid and closed form against independent numbers", "compact",
                  {{"Quantity"_html, false}, {"Largest relative error"_html}});
  for (const auto& [name, error] : reference.max_relative_error) table.add_row({text(name), number_html(error, 2)});
  return element("p", "Both were compared with "_html + count_html(cases) +
                          " cases that other programs computed ("_html + code_html(reference.file) + ")."_html) +
         table.html();
}

}  // namespace

Html ellipse_section(const Json& report) {
  const EllipseFindings findings = read_ellipses(report);
  const Html reference = reference_table(read_reference(report));
  if (findings.cases.empty() && reference.empty()) return {};
  Html html = element("h2", "All ellipses"_html);
  if (!findings.cases.empty()) {
    const std::vector<Group> groups = by_ray_model(findings.cases);
    html += element("p",
                    "Every prescription, distance and pupil. Semi-axes are major × minor, for rays 2 × standard "
                    "deviation; orientations are of the "
                    "major axis as the wearer sees it. Standard error: "_html +
                        text_or_dash(findings.conditions.standard_error) + "."_html) +
            summary_table(groups);
    for (const auto& [model, rows] : groups) {
      html +=
          folded(code_html(name_of(model)) + ": "_html + text(std::to_string(rows.size())) + " cases, worst first"_html,
                 case_table(name_of(model), rows));
    }
  }
  return element("section", {{"id", "ellipses"}}, html + reference);
}

}  // namespace sturm
