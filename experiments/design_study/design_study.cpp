#include "experiments/design_study/design_study.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/figures/lens_maps.h"
#include "experiments/figures/lens_plots.h"
#include "experiments/figures/wearer_table.h"
#include "io/files/csv.h"
#include "io/files/formatted_text.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

/// Largest size of a map's values, with its sign.
Number largest_of(const LensMap& map) {
  Number largest;
  for (const double value : map.values.reshaped())
    if (std::isfinite(value) && (!largest || std::abs(value) > std::abs(*largest))) largest = value;
  return largest;
}

/// Of the places that have a value, those where the larger principal value of the error is at most `clear_D` [%].
Number clear_percent(const LensMap& mean, const LensMap& cylinder, double clear_D) {
  int all = 0, clear = 0;
  for (Eigen::Index i = 0; i < mean.values.size(); ++i) {
    const double m = mean.values.reshaped()(i), c = cylinder.values.reshaped()(i);
    if (!std::isfinite(m) || !std::isfinite(c)) continue;
    ++all;
    clear += std::abs(m) + 0.5 * c <= clear_D;
  }
  return all > 0 ? Number(100.0 * clear / all) : std::nullopt;
}

/// Where the corridor of a progressive lens is narrowest between the horizon and its lower end.
void add_corridor(const CorridorProfile& profile, DesignFacts& facts) {
  for (const CorridorPlace& place : profile.places)
    if (place.elevation_deg <= 0.0 && place.azimuth_deg && place.width_deg &&
        (!facts.narrowest_deg || *place.width_deg < *facts.narrowest_deg)) {
      facts.narrowest_deg = place.width_deg;
      facts.narrowest_elevation_deg = place.elevation_deg;
    }
}

DesignWearer row_of(const WearerRow& row, const std::string& design) {
  const bool seen = row.lost < row.gazes;
  const auto where_seen = [&](double value) { return seen ? Number(value) : std::nullopt; };
  return {.wearer = row.wearer,
          .design = design,
          .distance_m = StoredDistance{row.distance_m},
          .sphere_D = row.prescription.sphere_D,
          .cylinder_D = row.prescription.cylinder_D,
          .axis_deg = row.prescription.axis_deg,
          .age_years = row.age_years,
          .amplitude_D = row.amplitude_D,
          .addition_D = row.addition_D,
          .gazes = row.gazes,
          .lost = row.lost,
          .share_blurred = where_seen(row.share_blurred),
          .median_D = where_seen(row.median_D),
          .largest_D = where_seen(row.largest_D),
          .status = row.not_made.empty() ? "ok" : row.not_made};
}

}  // namespace

DesignConditions conditions_of(const DesignStudySpec& study) {
  return {.clear_D = study.clear_D,
          .reach_deg = study.reach_deg,
          .step_deg = study.step_deg,
          .rotation_center_mm = study.rotation_center_m / metres_per_millimetre,
          .pupil_mm = study.pupil_diameter_m / metres_per_millimetre,
          .amplitude_D = study.amplitude_D};
}

DesignFacts facts_of(const DesignStudySpec& study, const StudyDesign& design) {
  const Spectacles& lens = *design.made.lens;
  const PowerMatrix nominal = nominal_power(design.made, {design.file, ""});
  const Prescription rx = nominal.as_prescription();
  const std::vector<LensMap> maps = as_worn_maps(lens, nominal, study.rotation_center_m);
  DesignFacts facts{.id = design.id,
                    .note = design.note,
                    .sphere_D = rx.sphere_D,
                    .cylinder_D = rx.cylinder_D,
                    .largest_mean_D = largest_of(maps[0]),
                    .largest_cylinder_D = largest_of(maps[1]),
                    .clear_area_percent = clear_percent(maps[0], maps[1], study.clear_D)};
  if (rx.cylinder_D != 0.0) facts.axis_deg = rx.axis_deg;
  if (design.document.contains("progressive"))
    add_corridor(corridor_profiles({{design.id, lens, nominal}}, study.rotation_center_m).front(), facts);
  return facts;
}

std::vector<DesignWearer> wearers_of(const DesignStudySpec& study, const StudyDesign& design) {
  const WearerQuestion question{.distances_m = study.distances_m,
                                .amplitude_D = study.population->amplitude_D,
                                .clear_D = study.clear_D,
                                .reach_deg = study.reach_deg,
                                .step_deg = study.step_deg,
                                .rotation_center_m = study.rotation_center_m};
  std::vector<DesignWearer> rows;
  for (const WearerRow& row :
       wearer_table(study.population->wearers, {{design.id, design.file, design.document}}, question))
    rows.push_back(row_of(row, design.id));
  return rows;
}

std::string design_study_csv(const DesignFindings& found) {
  CsvWriter csv;
  for (const char* heading :
       {"wearer", "design", "distance_m", "sphere_D", "cylinder_D", "axis_deg", "age_years", "amplitude_D",
        "addition_D", "gazes", "lost", "share_blurred", "median_D", "largest_D", "status"})
    csv.text(heading);
  csv.end_row();
  for (const DesignWearer& row : found.wearers) {
    csv.text(row.wearer);
    csv.text(row.design);
    csv.text(row.distance_m ? exact_number(row.distance_m->metres) : "");
    for (const Number& number :
         {row.sphere_D, row.cylinder_D, row.axis_deg, row.age_years, row.amplitude_D, row.addition_D})
      csv.number(number);
    for (const Count& count : {row.gazes, row.lost})
      csv.number(count ? Number(static_cast<double>(*count)) : std::nullopt);
    for (const Number& number : {row.share_blurred, row.median_D, row.largest_D}) csv.number(number);
    csv.text(row.status);
    csv.end_row();
  }
  return csv.table();
}

Json design_sentence(const DesignFindings& found) {
  const std::vector<DesignSummary> summaries = design_summaries(found);
  const DesignSummary *best = nullptr, *worst = nullptr;
  for (const DesignSummary& s : summaries) {
    if (!s.median_share) continue;
    if (!best || *s.median_share < *best->median_share) best = &s;
    if (!worst || *s.median_share > *worst->median_share) worst = &s;
  }
  if (!best) return nullptr;
  const auto words = [](const DesignSummary& s) {
    const bool far = !s.distance_m || s.distance_m->is_infinite();
    return formatted("%.0f %%", 100.0 * *s.median_share) + " (" + s.design + ", target " +
           (far ? "far away" : "at " + plain_number(s.distance_m->metres, 3) + " m") + ")";
  };
  return "Of the gazes of the median wearer, " + words(*best) + " to " + words(*worst) + " are blurred by more than " +
         plain_number(found.conditions.clear_D.value_or(0.0)) + " D.";
}

}  // namespace sturm
