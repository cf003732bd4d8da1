#include <algorithm>
#include <map>
#include <vector>

#include "compare/statistics/median.h"
#include "io/json/stored.h"
#include "lensmodel/units.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

struct Row {
  const Json* item;  ///< the case
  const Json* rays;  ///< one ray model of it
};

std::string_view what_it_is(const std::string& ray_model) {
  static const std::map<std::string, std::string_view> models = {
      {"pinhole", "the chief ray: no blur"},
      {"thin_lens", "depth of field with the spherical equivalent"},
      {"metalstigmatism", "sin² with focal distances added, as printed"},
      {"sin2_radial", "sin² with vergences added"},
      {"power_matrix", "wavefront theory to second order"}};
  const auto found = models.find(ray_model);
  return found == models.end() ? std::string_view() : found->second;
}

/// What a ray model has to agree with: sin² with its closed form, everything else with the conoid.
const Json& own_prediction(const Json& rays) {
  const Json& closed_form = value_at(rays, "against_closed_form");
  return closed_form.is_object() ? closed_form : value_at(rays, "against_conoid");
}

bool undefined(const Json& rays) {
  return text_at(rays, "status") != "ok";
}

/// Worst first: without a result, then by the largest |z|, then by the relative difference.
bool worse(const Row& a, const Row& b) {
  if (undefined(*a.rays) != undefined(*b.rays)) return undefined(*a.rays);
  const auto key = [](const Row& row, const char* name) { return number_at(own_prediction(*row.rays), name); };
  if (key(a, "z_max") != key(b, "z_max")) return key(a, "z_max") > key(b, "z_max");
  return key(a, "relative_frobenius") > key(b, "relative_frobenius");
}

/// The models that the project asks about come first.
int reading_order(const std::string& ray_model) {
  return ray_model == "power_matrix" ? 0 : ray_model == "sin2_radial" ? 1 : 2;
}

/// Rows by ray model, worst first.
std::vector<std::pair<std::string, std::vector<Row>>> by_ray_model(const Json& cases) {
  std::vector<std::pair<std::string, std::vector<Row>>> groups;
  for (const Json& item : cases) {
    for (const Json& rays : array_at(item, "rays")) {
      const std::string model = text_at(rays, "ray_model");
      auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == model; });
      if (group == groups.end()) group = groups.insert(groups.end(), {model, {}});
      group->second.push_back({&item, &rays});
    }
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const auto& a, const auto& b) { return reading_order(a.first) < reading_order(b.first); });
  for (auto& [model, rows] : groups) std::stable_sort(rows.begin(), rows.end(), worse);
  return groups;
}

std::vector<double> sorted_numbers(const std::vector<Row>& rows, std::string_view path) {
  std::vector<double> numbers;
  for (const Row& row : rows) {
    if (const auto number = number_at(*row.rays, path)) numbers.push_back(*number);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

std::optional<double> largest(const std::vector<double>& sorted) {
  return sorted.empty() ? std::nullopt : std::optional(sorted.back());
}

Html summary_table(const std::vector<std::pair<std::string, std::vector<Row>>>& groups) {
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
    const auto differences = sorted_numbers(rows, "against_conoid/relative_frobenius");
    table.add_row({code_html(model), text(what_it_is(model)), count_html(static_cast<double>(rows.size())),
                   count_html(static_cast<double>(without)), number_html(median(differences), 3),
                   number_html(largest(differences), 3),
                   number_html(largest(sorted_numbers(rows, "against_conoid/z_max")), 3),
                   number_html(largest(sorted_numbers(rows, "against_closed_form/z_max")), 3)});
  }
  return table.html();
}

Html semi_axes_html(const Json& ellipse) {
  const auto axis = [&](const char* path) {
    const auto radians = number_at(ellipse, path);
    return radians ? std::optional(*radians * arcminutes_per_radian) : std::nullopt;
  };
  const auto major = axis("semi_axes_rad/0"), minor = axis("semi_axes_rad/1");
  return major && minor ? number_html(major) + " × "_html + number_html(minor) : absent_html();
}

Html degrees_html(const Json& json, const char* path) {
  return number_html(number_at(json, path), 3);
}

Html status_html(const Json& rays) {
  Html html = text_or_dash(text_at(rays, "status"));
  for (const auto& [key, name] :
       {std::pair("dropped", "dropped"), std::pair("negative_focus", "with negative focus")}) {
    const auto count = number_at(rays, std::string("counters/") + key);
    if (count && *count > 0.0) html += small_html(count_html(count) + " "_html + text(name));
  }
  return html;
}

Cell sortable(std::optional<double> value, int significant) {
  return {number_html(value, significant), value};
}

Html case_table(const std::string& model, const std::vector<Row>& rows) {
  const bool closed_form = std::any_of(
      rows.begin(), rows.end(), [](const Row& r) { return value_at(*r.rays, "against_closed_form").is_object(); });
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
    const Json &item = *row.item, &rays = *row.rays;
    std::vector<Cell> cells = {
        text_or_dash(text_at(item, "id")),
        {semi_axes_html(value_at(item, "conoid")), number_at(item, "conoid/semi_axes_rad/0")},
        {degrees_html(item, "conoid/orientation_deg"), number_at(item, "conoid/orientation_deg")},
        {semi_axes_html(rays), number_at(rays, "semi_axes_rad/0")},
        {degrees_html(rays, "orientation_deg"), number_at(rays, "orientation_deg")},
        sortable(number_at(rays, "against_conoid/relative_frobenius"), 3),
        sortable(number_at(rays, "against_conoid/z_max"), 3),
        sortable(number_at(rays, "against_conoid/minor_axis_error_arcmin"), 2),
        sortable(number_at(rays, "against_conoid/orientation_error_deg"), 2),
        sortable(number_at(rays, "against_conoid/bures_wasserstein_arcmin"), 2)};
    if (closed_form) {
      cells.push_back(sortable(number_at(rays, "against_closed_form/relative_frobenius"), 3));
      cells.push_back(sortable(number_at(rays, "against_closed_form/z_max"), 3));
    }
    cells.push_back(status_html(rays));
    table.add_row(cells, undefined(rays) ? "fail" : "");
  }
  return table.html();
}

Html reference_table(const Json& reference) {
  HtmlTable table("Conoid and closed form against independent numbers", "compact",
                  {{"Quantity"_html, false}, {"Largest relative error"_html}});
  const Json& errors = value_at(reference, "max_relative_error");
  if (!errors.is_object()) return {};
  for (const auto& [name, error] : errors.items()) table.add_row({text(name), number_html(number_at(error, ""), 2)});
  return element("p", "Both were compared with "_html + count_html(number_at(reference, "cases")) +
                          " cases that other programs computed ("_html + code_html(text_at(reference, "file")) +
                          ")."_html) +
         table.html();
}

}  // namespace

Html ellipse_section(const Json& report) {
  const Json& cases = array_at(report, "ellipses/cases");
  const Html reference = reference_table(value_at(report, "reference"));
  if (cases.empty() && reference.empty()) return {};
  Html html = element("h2", "All ellipses"_html);
  if (!cases.empty()) {
    const auto groups = by_ray_model(cases);
    html += element("p",
                    "Every prescription, distance and pupil. Semi-axes are major × minor, for rays 2 × standard "
                    "deviation; orientations are of the "
                    "major axis as the wearer sees it. Standard error: "_html +
                        text_or_dash(text_at(report, "ellipses/conditions/standard_error")) + "."_html) +
            summary_table(groups);
    for (const auto& [model, rows] : groups) {
      html += folded(code_html(model) + ": "_html + text(std::to_string(rows.size())) + " cases, worst first"_html,
                     case_table(model, rows));
    }
  }
  return element("section", {{"id", "ellipses"}}, html + reference);
}

}  // namespace sturm
