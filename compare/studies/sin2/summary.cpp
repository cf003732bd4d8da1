#include "compare/studies/sin2/summary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "io/json/values.h"

namespace sturm {

namespace {

/// Rank statistics of a list: the smallest value that at least this share of the list does not exceed.
Json quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return nullptr;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::min(sorted.size() - 1, rank > 0 ? rank - 1 : 0)];
}

Json distribution(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {{"median", quantile(values, 0.5)}, {"p90", quantile(values, 0.9)}, {"max", quantile(values, 1.0)}};
}

/// What one model does to the real eyes in some views.
struct PopulationRow {
  std::vector<double> error_D, error_arcmin, error_percent;
  std::size_t eyes = 0, pole = 0;

  void add(const StudyCase& c) {
    ++eyes;
    pole += c.status == StudyStatus::pole;
    const struct {
      StudyQuantity q;
      std::vector<double>* list;
    } columns[] = {{StudyQuantity::error_D, &error_D},
                   {StudyQuantity::error_arcmin, &error_arcmin},
                   {StudyQuantity::error_percent, &error_percent}};
    for (const auto& column : columns)
      if (c[column.q]) column.list->push_back(*c[column.q]);
  }

  Json json() const {
    const auto noticed =
        std::count_if(error_D.begin(), error_D.end(), [](double error) { return error > noticeable_defocus_D; });
    return {{"eyes", eyes},
            {"pole", pole},
            {"noticeable", noticed},
            {"error_D", distribution(error_D)},
            {"error_arcmin", distribution(error_arcmin)},
            {"error_percent", distribution(error_percent)}};
  }
};

bool at_reference(const StudyCase& c, const Sin2StudySpec& spec) {
  return c.pupil == spec.reference_pupil && c.distance == spec.reference_distance &&
         c.accommodation == spec.reference_accommodation;
}

/// Error [D] over the grid, a row per cylinder; null where the model has none.
Json map_of(const Sin2StudySpec& spec, const std::map<std::pair<double, double>, const StudyCase*>& grid) {
  Json rows = Json::array();
  for (const double cylinder : spec.cylinders_D) {
    Json row = Json::array();
    for (const double sphere : spec.spheres_D) {
      const auto at = grid.find({sphere, cylinder});
      row.push_back(at == grid.end() ? Json(nullptr) : number_or_null((*at->second)[StudyQuantity::error_D]));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

Json model_table(const Sin2StudySpec& spec, const std::vector<StudyCase>& cases) {
  Json table = Json::array();
  for (const RayModel model : study_models) {
    std::size_t total = 0, undefined = 0, pole = 0;
    double rays = 0.0, dropped = 0.0, negative = 0.0;
    const StudyCase* worst = nullptr;
    for (const StudyCase& c : cases) {
      if (c.model != model) continue;
      ++total;
      undefined += c.status == StudyStatus::undefined;
      pole += c.status == StudyStatus::pole;
      rays += c[StudyQuantity::rays].value_or(0.0);
      dropped += c[StudyQuantity::rays_dropped].value_or(0.0);
      negative += c[StudyQuantity::rays_negative_focus].value_or(0.0);
      if (c[StudyQuantity::error_D] && (!worst || *c[StudyQuantity::error_D] > *(*worst)[StudyQuantity::error_D]))
        worst = &c;
    }
    table.push_back({{"ray_model", name_of(model)},
                     {"title", title_of(model)},
                     {"cases", total},
                     {"undefined", undefined},
                     {"pole", pole},
                     {"rays", rays},
                     {"rays_dropped", dropped},
                     {"rays_negative_focus", negative},
                     {"largest_error_D", worst ? number_or_null((*worst)[StudyQuantity::error_D]) : Json(nullptr)},
                     {"largest_error_case", worst ? Json(label_of(*worst, spec)) : Json(nullptr)}});
  }
  return table;
}

Json population_table(const Sin2StudySpec& spec, const std::vector<StudyCase>& cases) {
  std::map<std::tuple<RayModel, std::size_t, std::size_t>, PopulationRow> views;
  std::map<std::pair<RayModel, std::size_t>, const StudyCase*> worst_of_eye;
  for (const StudyCase& c : cases) {
    if (c.eye < spec.grid_eyes || c.pupil != spec.reference_pupil || c.status == StudyStatus::undefined) continue;
    views[{c.model, c.accommodation, c.distance}].add(c);
    // A pole is worse than any error; among errors the larger one.
    const StudyCase*& worst = worst_of_eye[{c.model, c.eye}];
    const bool worse =
        !worst || (worst->status == StudyStatus::ok &&
                   (c.status == StudyStatus::pole || *c[StudyQuantity::error_D] > *(*worst)[StudyQuantity::error_D]));
    if (worse) worst = &c;
  }
  Json table = Json::array();
  for (const auto& [key, row] : views) {
    Json entry = row.json();
    entry["ray_model"] = name_of(std::get<0>(key));
    entry["accommodation"] = label_of(spec.accommodations[std::get<1>(key)]);
    entry["distance_m"] = distance_json(spec.distances_m[std::get<2>(key)]);
    table.push_back(std::move(entry));
  }
  std::map<RayModel, PopulationRow> anywhere;
  for (const auto& [key, worst] : worst_of_eye) anywhere[key.first].add(*worst);
  for (const auto& [model, row] : anywhere) {
    Json entry = row.json();
    entry["ray_model"] = name_of(model);
    entry["accommodation"] = nullptr;
    entry["distance_m"] = nullptr;
    table.push_back(std::move(entry));
  }
  return table;
}

Json reference_views(const Sin2StudySpec& spec, const std::vector<StudyCase>& cases) {
  Json maps = Json::array(), curves = Json::array(), cumulative = Json::array();
  for (const RayModel model : study_models) {
    std::map<std::pair<double, double>, const StudyCase*> grid;
    std::vector<double> errors;
    Json points = Json::array();
    for (const StudyCase& c : cases) {
      if (c.model != model || !at_reference(c, spec)) continue;
      if (c.eye >= spec.grid_eyes) {
        if (c[StudyQuantity::error_D]) errors.push_back(*c[StudyQuantity::error_D]);
        continue;
      }
      const Prescription& rx = spec.eyes[c.eye].prescription;
      grid.insert({{rx.sphere_D, rx.cylinder_D}, &c});  // the first axis stays
      if (rx.cylinder_D == 0.0)
        points.push_back({rx.sphere_D, number_or_null(c[StudyQuantity::true_major_arcmin]),
                          number_or_null(c[StudyQuantity::major_arcmin])});
    }
    std::sort(errors.begin(), errors.end());
    maps.push_back({{"ray_model", name_of(model)}, {"error_D", map_of(spec, grid)}});
    curves.push_back({{"ray_model", name_of(model)}, {"points", std::move(points)}});
    cumulative.push_back({{"ray_model", name_of(model)}, {"error_D", errors}});
  }
  return {{"spheres_D", spec.spheres_D},
          {"cylinders_D", spec.cylinders_D},
          {"maps", std::move(maps)},
          {"curves", std::move(curves)},
          {"cumulative", std::move(cumulative)}};
}

Json summarised_sin2_study(const Sin2StudySpec& spec, const std::vector<StudyCase>& cases, const Json& gallery) {
  Json distances = Json::array(), pupils = Json::array(), accommodations = Json::array();
  for (const double d : spec.distances_m) distances.push_back(distance_json(d));
  for (const double p : spec.pupil_diameters_m) pupils.push_back(1e3 * p);
  for (const Accommodation& a : spec.accommodations) accommodations.push_back(label_of(a));
  Json conditions = {{"eyes", spec.eyes.size()},
                     {"grid_eyes", spec.grid_eyes},
                     {"real_eyes", spec.eyes.size() - spec.grid_eyes},
                     {"distances_m", std::move(distances)},
                     {"pupil_diameters_mm", std::move(pupils)},
                     {"accommodations", std::move(accommodations)},
                     {"radial", spec.quadrature.radial},
                     {"azimuthal", spec.quadrature.azimuthal},
                     {"rings", spec.rings.rings},
                     {"angle_factor", spec.rings.angle_factor},
                     {"reference_distance_m", distance_json(spec.distances_m[spec.reference_distance])},
                     {"reference_pupil_mm", 1e3 * spec.pupil_diameters_m[spec.reference_pupil]},
                     {"gallery_rays", spec.gallery_rays}};
  return {{"conditions", std::move(conditions)},
          {"models", model_table(spec, cases)},
          {"checks", study_checks(spec, cases)},
          {"population", population_table(spec, cases)},
          {"reference_view", reference_views(spec, cases)},
          {"gallery", gallery}};
}

}  // namespace sturm
