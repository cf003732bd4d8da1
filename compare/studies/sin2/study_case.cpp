#include "compare/studies/sin2/study_case.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/files/csv.h"
#include "io/files/formatted_text.h"
#include "io/json/values.h"

namespace sturm {

namespace {

constexpr std::array quantity_names{"V1_D",
                                    "V2_D",
                                    "true_semi_major_arcmin",
                                    "true_semi_minor_arcmin",
                                    "semi_major_arcmin",
                                    "semi_minor_arcmin",
                                    "error_D",
                                    "error_arcmin",
                                    "error_percent",
                                    "theory_deviation",
                                    "closed_form_deviation",
                                    "radial_deviation_D",
                                    "difference_ratio",
                                    "lost_variance_ratio",
                                    "uniform_polar_rms",
                                    "uniform_polar_weighted_rms",
                                    "rings_rms",
                                    "rays",
                                    "rays_dropped",
                                    "rays_negative_focus",
                                    "repaired_deviation",
                                    "mutant_repaired_as_sin2",
                                    "mutant_wrong_coefficient",
                                    "mutant_mirrored_axis",
                                    "mutant_sin2_as_matrix"};
static_assert(quantity_names.size() == quantity_count);

std::string length_text(double metres) {
  return std::isinf(metres) ? "inf" : plain_number(metres) + " m";
}

/// All that is to be read off so many lines; the report has the extremes in full.
constexpr int digits_in_csv = 9;

/// What the checks on wrong inputs read is no finding about a case.
constexpr std::size_t quantities_in_csv = static_cast<std::size_t>(StudyQuantity::mutant_repaired_as_sin2);

}  // namespace

const char* title_of(RayModel study_model) {
  switch (study_model) {
    case RayModel::metalstigmatism:
      return "focal distances added, as printed";
    case RayModel::sin2_radial:
      return "sin², vergences added";
    default:
      return "wavefront theory";
  }
}

const char* name_of(StudyQuantity quantity) {
  return quantity_names[static_cast<std::size_t>(quantity)];
}

const char* name_of(StudyStatus status) {
  switch (status) {
    case StudyStatus::undefined:
      return "undefined";
    case StudyStatus::pole:
      return "pole";
    default:
      return "ok";
  }
}

double relative_deviation(const Eigen::Matrix2d& is, const Eigen::Matrix2d& should, double a) {
  return (is - should).norm() / (should.norm() + 0.25 * a * a);
}

Json row_of(const StudyCase& c) {
  const auto model = std::find(study_models.begin(), study_models.end(), c.model) - study_models.begin();
  Json row = {c.eye, c.distance, c.pupil, c.accommodation, model, static_cast<int>(c.status)};
  for (const auto& value : c.values) row.push_back(number_or_null(value));
  return row;
}

StudyCase case_of(const Json& row) {
  StudyCase c;
  c.eye = row.at(0);
  c.distance = row.at(1);
  c.pupil = row.at(2);
  c.accommodation = row.at(3);
  c.model = study_models.at(row.at(4).get<std::size_t>());
  c.status = static_cast<StudyStatus>(row.at(5).get<int>());
  constexpr std::size_t first_number = 6;
  for (std::size_t i = 0; i < quantity_count; ++i)
    if (const Json& value = row.at(first_number + i); value.is_number()) c.values[i] = value.get<double>();
  return c;
}

std::string label_of(const Accommodation& accommodation) {
  if (const auto* fixed = std::get_if<FixedAccommodation>(&accommodation))
    return fixed->focus_distance_m > 0.0 ? "focus " + length_text(fixed->focus_distance_m)
                                         : "accommodation " + plain_number(fixed->power_D) + " D";
  if (const auto* best = std::get_if<BestAccommodation>(&accommodation))
    return "best, up to " + plain_number(best->amplitude_D) + " D";
  return "relaxed";
}

std::string label_of(const StudyCase& c, const Sin2StudySpec& spec) {
  return spec.eyes.at(c.eye).id + "|" + length_text(spec.distances_m.at(c.distance)) + "|" +
         plain_number(1e3 * spec.pupil_diameters_m.at(c.pupil)) + " mm|" +
         label_of(spec.accommodations.at(c.accommodation)) + "|" + name_of(c.model);
}

std::string sin2_study_csv(const std::vector<StudyCase>& cases, const Sin2StudySpec& spec) {
  CsvWriter csv;
  for (const char* heading : {"eye", "sphere_D", "cylinder_D", "axis_deg", "vertex_distance_mm", "distance_m",
                              "pupil_mm", "accommodation", "ray_model", "status"})
    csv.text(heading);
  for (std::size_t i = 0; i < quantities_in_csv; ++i) csv.text(quantity_names[i]);
  csv.end_row();
  for (const StudyCase& c : cases) {
    const StudyEye& eye = spec.eyes.at(c.eye);
    csv.text(eye.id);
    for (const double value : {eye.prescription.sphere_D, eye.prescription.cylinder_D, eye.prescription.axis_deg,
                               1e3 * eye.prescription.vertex_distance_m, spec.distances_m.at(c.distance),
                               1e3 * spec.pupil_diameters_m.at(c.pupil)})
      csv.number(value, digits_in_csv);
    csv.text(label_of(spec.accommodations.at(c.accommodation)));
    csv.text(name_of(c.model));
    csv.text(name_of(c.status));
    for (std::size_t i = 0; i < quantities_in_csv; ++i) csv.number(c.values[i], digits_in_csv);
    csv.end_row();
  }
  return csv.table();
}

}  // namespace sturm
