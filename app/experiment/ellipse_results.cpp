#include <cmath>
#include <nlohmann/json.hpp>

#include "app/experiment/case_names.h"
#include "app/experiment/sections.h"
#include "app/json_values.h"
#include "app/ray_bundle.h"
#include "compare/ellipse_comparison.h"
#include "compare/ellipse_measures.h"
#include "conoid/footprint.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

/// `scale`: from the measure's unit to that of the file.
Json measure_json(const std::optional<EllipseMeasure>& m, double scale = 1.0) {
  if (!m) return nullptr;
  return {{"value", scale * m->value},
          {"standard_error", m->standard_error ? number_or_null(scale * *m->standard_error) : Json(nullptr)},
          {"z", number_or_null(m->z)}};
}

Json measures_json(const EllipseMeasures& m) {
  constexpr double arcmin = arcminutes_per_radian;
  return {{"semi_major_arcmin", measure_json(m.semi_major, arcmin)},
          {"semi_minor_arcmin", measure_json(m.semi_minor, arcmin)},
          {"orientation_deg", measure_json(m.orientation)},
          {"log_area_ratio", measure_json(m.log_area_ratio)},
          {"frobenius_arcmin2", measure_json(m.frobenius, arcmin * arcmin)},
          {"bures_wasserstein_arcmin", measure_json(m.bures_wasserstein, arcmin)},
          {"missing_overlap", measure_json(m.missing_overlap)}};
}

Json against_conoid_json(const EllipseComparison& c, const EllipseMeasures& measures) {
  return {{"measures", measures_json(measures)},
          {"z_max", number_or_null(c.z_max)},
          {"relative_frobenius", number_or_null(c.relative_frobenius)},
          {"semi_axis_errors", {number_or_null(c.semi_major_relative_error), number_or_null(c.semi_minor_relative_error)}},
          {"minor_axis_error_arcmin", c.semi_minor_error * arcminutes_per_radian},
          {"orientation_error_deg", number_or_null(c.orientation_error_deg)},
          {"bures_wasserstein_arcmin", c.bures_wasserstein * arcminutes_per_radian}};
}

Json rays_json(RayModel model, const Eye& eye, const Footprint& footprint, const RayBundleSpec& spec, std::uint64_t seed) {
  Json entry = {{"ray_model", name_of(model)}, {"status", "undefined"},         {"semi_axes_rad", nullptr},
                {"orientation_deg", nullptr},  {"covariance_rad2", nullptr},    {"covariance_standard_error_rad2", nullptr},
                {"against_conoid", nullptr},   {"against_closed_form", nullptr}};
  const auto rays = eye_rays_for(model, eye, footprint.accommodation_D);
  if (!rays) return entry;
  const double vergence = vergence_of(footprint.distance_m);
  const MeasuredBundle bundle = measure_bundle(*rays, vergence, spec, seed);
  entry["counters"] = {
      {"launched", bundle.counters.launched}, {"dropped", bundle.counters.dropped}, {"negative_focus", bundle.counters.negative_focus}};
  if (!bundle.angular) return entry;
  const BundleEllipse& measured = *bundle.angular;
  entry["status"] = "ok";
  entry["semi_axes_rad"] = semi_axes_json(measured.ellipse);
  entry["orientation_deg"] = number_or_null(measured.ellipse.orientation_deg);
  entry["covariance_rad2"] = symmetric_json(measured.covariance);
  if (const auto error = measured.covariance_standard_error()) entry["covariance_standard_error_rad2"] = json_of(*error);
  const Eigen::Matrix2d predicted = covariance_of_disc_image(footprint.angular, eye.pupil_radius_m);
  entry["against_conoid"] = against_conoid_json(compare_to_prediction(measured, predicted), measure_ellipses(measured, predicted));
  if (model == RayModel::sin2_radial) {
    const auto c = compare_to_prediction(measured, sin2_closed_form_covariance(footprint.angular, eye.pupil_radius_m));
    entry["against_closed_form"] = {{"z_max", number_or_null(c.z_max)}, {"relative_frobenius", number_or_null(c.relative_frobenius)}};
  }
  return entry;
}

Json case_json(const NamedPrescription& named, double distance_m, const Eye& eye, const EllipseExperiment& spec, std::uint64_t seed) {
  const Footprint footprint = naked_eye_footprint(eye, distance_m);
  const double a = eye.pupil_radius_m;
  const Ellipse ellipse = Ellipse::image_of_disc(footprint.angular, a);
  const Eigen::Matrix2d sin2 = sin2_closed_form_covariance(footprint.angular, a);
  Json rays = Json::array();
  for (const std::string& model : spec.ray_models) rays.push_back(rays_json(*ray_model_named(model), eye, footprint, spec.rays, seed));
  const Prescription& rx = named.prescription;
  return {{"id", case_name(named.id, distance_m, 2.0 * a)},
          {"prescription", named.id},
          {"sphere_D", rx.sphere_D},
          {"cylinder_D", rx.cylinder_D},
          {"axis_deg", rx.axis_deg},
          {"vertex_distance_mm", 1e3 * rx.vertex_distance_m},
          {"distance_m", distance_json(distance_m)},
          {"pupil_mm", 2e3 * a},
          {"accommodation_D", footprint.accommodation_D},
          {"conoid",
           {{"semi_axes_rad", semi_axes_json(ellipse)},
            {"orientation_deg", number_or_null(ellipse.orientation_deg)},
            {"covariance_rad2", symmetric_json(covariance_of_disc_image(footprint.angular, a))}}},
          {"sin2_closed_form",
           {{"covariance_rad2", symmetric_json(sin2)}, {"semi_axes_rad", semi_axes_json(Ellipse::of_second_moments(sin2))}}},
          {"rays", std::move(rays)}};
}

}  // namespace

Json ellipse_results(const EllipseExperiment& spec, std::uint64_t seed, const ProgressFunction& progress) {
  Json cases = Json::array();
  const double total = static_cast<double>(spec.prescriptions.size() * spec.distances_m.size() * spec.pupil_diameters_m.size());
  for (const NamedPrescription& named : spec.prescriptions)
    for (double pupil : spec.pupil_diameters_m) {
      const Eye eye = Eye::with(named.prescription, pupil, spec.accommodation);
      for (double distance : spec.distances_m) {
        cases.push_back(case_json(named, distance, eye, spec, seed));
        progress(static_cast<double>(cases.size()) / total);
      }
    }
  const bool sobol = spec.rays.sequence == Sequence::Sobol;
  return {{"conditions",
           {{"rays_per_replicate", spec.rays.count},
            {"replicates", spec.rays.replicates},
            {"sampling", "uniform_disk"},
            {"sequence", sobol ? "sobol" : "independent"},
            {"standard_error", "scatter between replicates / sqrt(replicates)"}}},
          {"cases", std::move(cases)}};
}

}  // namespace sturm
