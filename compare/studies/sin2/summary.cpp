#include "compare/studies/sin2/summary.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace sturm {

namespace {

/// Rank statistics of a list: the smallest value that at least this share of the list does not exceed.
Number quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return std::nullopt;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::min(sorted.size() - 1, rank > 0 ? rank - 1 : 0)];
}

Distribution distribution(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {.median = quantile(values, 0.5), .p90 = quantile(values, 0.9), .max = quantile(values, 1.0)};
}

/// What one model does to the real eyes in some views.
struct Tally {
  std::vector<double> error_D, error_arcmin, error_percent;
  std::int64_t eyes = 0, pole = 0;

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

  Sin2PopulationRow row(RayModel model) const {
    const auto noticed =
        std::count_if(error_D.begin(), error_D.end(), [](double error) { return error > noticeable_defocus_D; });
    return {.ray_model = model,
            .eyes = eyes,
            .pole = pole,
            .noticeable = noticed,
            .error_D = distribution(error_D),
            .error_arcmin = distribution(error_arcmin),
            .error_percent = distribution(error_percent)};
  }
};

bool at_reference(const StudyCase& c, const Sin2StudySpec& spec) {
  return c.pupil == spec.reference_pupil && c.distance == spec.reference_distance &&
         c.accommodation == spec.reference_accommodation;
}

/// Error [D] over the grid, a row per cylinder; none where the model has none.
std::vector<std::vector<Number>> map_of(const Sin2StudySpec& spec,
                                        const std::map<std::pair<double, double>, const StudyCase*>& grid) {
  std::vector<std::vector<Number>> rows;
  for (const double cylinder : spec.cylinders_D) {
    std::vector<Number> row;
    for (const double sphere : spec.spheres_D) {
      const auto at = grid.find({sphere, cylinder});
      row.push_back(at == grid.end() ? std::nullopt : (*at->second)[StudyQuantity::error_D]);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

std::vector<Sin2ModelRow> model_table(const Sin2StudySpec& spec, const std::vector<StudyCase>& cases) {
  std::vector<Sin2ModelRow> table;
  for (const RayModel model : study_models) {
    std::int64_t total = 0, undefined = 0, pole = 0;
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
    table.push_back({.ray_model = model,
                     .title = title_of(model),
                     .cases = total,
                     .undefined = undefined,
                     .pole = pole,
                     .rays = rays,
                     .rays_dropped = dropped,
                     .rays_negative_focus = negative,
                     .largest_error_D = worst ? (*worst)[StudyQuantity::error_D] : std::nullopt,
                     .largest_error_case = worst ? std::optional(label_of(*worst, spec)) : std::nullopt});
  }
  return table;
}

std::vector<Sin2PopulationRow> population_table(const Sin2StudySpec& spec, const std::vector<StudyCase>& cases) {
  std::map<std::tuple<RayModel, std::size_t, std::size_t>, Tally> views;
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
  std::vector<Sin2PopulationRow> table;
  for (const auto& [key, tally] : views) {
    Sin2PopulationRow row = tally.row(std::get<0>(key));
    row.accommodation = label_of(spec.accommodations[std::get<1>(key)]);
    row.distance_m = StoredDistance{spec.distances_m[std::get<2>(key)]};
    table.push_back(std::move(row));
  }
  std::map<RayModel, Tally> anywhere;
  for (const auto& [key, worst] : worst_of_eye) anywhere[key.first].add(*worst);
  for (const auto& [model, tally] : anywhere) table.push_back(tally.row(model));
  return table;
}

Sin2ReferenceView reference_views(const Sin2StudySpec& spec, const std::vector<StudyCase>& cases) {
  Sin2ReferenceView view{.spheres_D = spec.spheres_D, .cylinders_D = spec.cylinders_D};
  for (const RayModel model : study_models) {
    std::map<std::pair<double, double>, const StudyCase*> grid;
    std::vector<Number> errors;
    std::vector<std::array<Number, 3>> points;
    for (const StudyCase& c : cases) {
      if (c.model != model || !at_reference(c, spec)) continue;
      if (c.eye >= spec.grid_eyes) {
        if (c[StudyQuantity::error_D]) errors.push_back(c[StudyQuantity::error_D]);
        continue;
      }
      const Prescription& rx = spec.eyes[c.eye].prescription;
      grid.insert({{rx.sphere_D, rx.cylinder_D}, &c});  // the first axis stays
      if (rx.cylinder_D == 0.0)
        points.push_back({rx.sphere_D, c[StudyQuantity::true_major_arcmin], c[StudyQuantity::major_arcmin]});
    }
    std::sort(errors.begin(), errors.end());
    view.maps.push_back({model, map_of(spec, grid)});
    view.curves.push_back({model, std::move(points)});
    view.cumulative.push_back({model, std::move(errors)});
  }
  return view;
}

Sin2StudyFindings summarised_sin2_study(const Sin2StudySpec& spec, const std::vector<StudyCase>& cases,
                                        std::vector<Sin2GalleryEntry> gallery) {
  const auto count = [](std::size_t number) { return static_cast<std::int64_t>(number); };
  Sin2Conditions conditions{.eyes = count(spec.eyes.size()),
                            .grid_eyes = count(spec.grid_eyes),
                            .real_eyes = count(spec.eyes.size() - spec.grid_eyes),
                            .radial = spec.quadrature.radial,
                            .azimuthal = spec.quadrature.azimuthal,
                            .rings = spec.rings.rings,
                            .angle_factor = spec.rings.angle_factor,
                            .reference_distance_m = StoredDistance{spec.distances_m[spec.reference_distance]},
                            .reference_pupil_mm = 1e3 * spec.pupil_diameters_m[spec.reference_pupil],
                            .gallery_rays = count(spec.gallery_rays)};
  for (const double d : spec.distances_m) conditions.distances_m.push_back({d});
  for (const double p : spec.pupil_diameters_m) conditions.pupil_diameters_mm.push_back(1e3 * p);
  for (const Accommodation& a : spec.accommodations) conditions.accommodations.push_back(label_of(a));
  return {.conditions = std::move(conditions),
          .models = model_table(spec, cases),
          .checks = study_checks(spec, cases),
          .population = population_table(spec, cases),
          .reference_view = reference_views(spec, cases),
          .gallery = std::move(gallery)};
}

}  // namespace sturm
