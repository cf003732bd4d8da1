#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/ellipses/ellipse_comparison.h"
#include "compare/ellipses/ellipse_measures.h"
#include "conoid/tracing/footprint.h"
#include "experiments/run/sections.h"
#include "experiments/standard/case_names.h"
#include "io/json/values.h"
#include "lensmodel/units.h"
#include "stages/ray_bundle.h"

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

/// What gates look at.
Json agreement_json(const EllipseComparison& c) {
  return {{"z_max", number_or_null(c.z_max)}, {"relative_frobenius", number_or_null(c.relative_frobenius)}};
}

Json against_conoid_json(const EllipseComparison& c, const EllipseMeasures& measures) {
  Json json = agreement_json(c);
  json.update(
      {{"measures", measures_json(measures)},
       {"semi_axis_errors", {number_or_null(c.semi_major_relative_error), number_or_null(c.semi_minor_relative_error)}},
       {"minor_axis_error_arcmin", c.semi_minor_error * arcminutes_per_radian},
       {"orientation_error_deg", number_or_null(c.orientation_error_deg)},
       {"bures_wasserstein_arcmin", c.bures_wasserstein * arcminutes_per_radian}});
  return json;
}

/// The bundles of one case; none for models that are undefined there.
using Bundles = std::vector<std::pair<RayModel, std::optional<MeasuredBundle>>>;

Json rays_json(RayModel model, const std::optional<MeasuredBundle>& bundle, const Eye& eye,
               const Footprint& footprint) {
  Json entry = {{"ray_model", name_of(model)}, {"status", "undefined"},
                {"semi_axes_rad", nullptr},    {"orientation_deg", nullptr},
                {"covariance_rad2", nullptr},  {"covariance_standard_error_rad2", nullptr},
                {"against_conoid", nullptr},   {"against_closed_form", nullptr}};
  if (!bundle) return entry;
  entry["counters"] = {{"launched", bundle->counters.launched},
                       {"dropped", bundle->counters.dropped},
                       {"negative_focus", bundle->counters.negative_focus}};
  if (!bundle->angular) return entry;
  const BundleEllipse& measured = *bundle->angular;
  entry["status"] = "ok";
  entry["semi_axes_rad"] = semi_axes_json(measured.ellipse);
  entry["orientation_deg"] = number_or_null(measured.ellipse.orientation_deg);
  entry["covariance_rad2"] = symmetric_json(measured.covariance);
  if (const auto error = measured.covariance_standard_error())
    entry["covariance_standard_error_rad2"] = json_of(*error);
  const Eigen::Matrix2d predicted = covariance_of_disc_image(footprint.angular, eye.pupil_radius_m);
  entry["against_conoid"] =
      against_conoid_json(compare_to_prediction(measured, predicted), measure_ellipses(measured, predicted));
  if (model == RayModel::sin2_radial)
    entry["against_closed_form"] = agreement_json(
        compare_to_prediction(measured, sin2_closed_form_covariance(footprint.angular, eye.pupil_radius_m)));
  return entry;
}

/// What a mutation makes of a case, as a patch (RFC 7396) of it; null where it is none of ellipses. `eye` and
/// `footprint` are the honest ones: the closed form of sin², which is no ellipse of the conoid's, follows a wrong
/// prescription but not a wrong semi-axis.
Json mutated_case(const Mutation& mutation, const Bundles& bundles, const Eye& eye, const Footprint& footprint) {
  const std::optional<Footprint> wrong = mutated_footprint(mutation, eye, footprint);
  const bool dropped = std::holds_alternative<mutation::DroppedTangentialTerm>(mutation.kind);
  if (!wrong && !dropped) return nullptr;
  const double a = eye.pupil_radius_m;
  const Eigen::Matrix2d conoid = covariance_of_disc_image(wrong.value_or(footprint).angular, a);
  const bool other_eye = std::holds_alternative<mutation::WrongPrescription>(mutation.kind);
  const Eigen::Matrix2d sin2 = sin2_closed_form_covariance(other_eye ? wrong->angular : footprint.angular, a);
  Json rays = Json::array();
  const auto add = [&](RayModel passed_off_as, const std::optional<MeasuredBundle>& bundle) {
    const bool measured = bundle && bundle->angular;
    rays.push_back(
        {{"ray_model", name_of(passed_off_as)},
         {"against_conoid", measured ? agreement_json(compare_to_prediction(*bundle->angular, conoid)) : Json(nullptr)},
         {"against_closed_form",
          measured ? agreement_json(compare_to_prediction(*bundle->angular, sin2)) : Json(nullptr)}});
  };
  for (const auto& [model, bundle] : bundles) {
    if (dropped && model == RayModel::sin2_radial) add(RayModel::power_matrix, bundle);
    if (!dropped || model != RayModel::power_matrix) add(model, bundle);
  }
  return {{"conoid", {{"covariance_rad2", symmetric_json(conoid)}}},
          {"sin2_closed_form", {{"covariance_rad2", symmetric_json(sin2)}}},
          {"rays", std::move(rays)}};
}

Json case_json(const NamedPrescription& named, double distance_m, const Eye& eye, const EllipseExperiment& spec,
               std::uint64_t seed, std::span<const Mutation> mutations) {
  const Footprint footprint = naked_eye_footprint(eye, distance_m);
  const double a = eye.pupil_radius_m;
  const Ellipse ellipse = Ellipse::image_of_disc(footprint.angular, a);
  const Eigen::Matrix2d sin2 = sin2_closed_form_covariance(footprint.angular, a);
  Bundles bundles;
  Json rays = Json::array();
  for (const RayModel model : spec.ray_models) {
    const auto eye_rays = eye_rays_for(model, eye, footprint.accommodation_D);
    bundles.emplace_back(
        model, eye_rays ? std::optional(measure_bundle(*eye_rays, vergence_of(footprint.distance_m), spec.rays, seed))
                        : std::nullopt);
    rays.push_back(rays_json(model, bundles.back().second, eye, footprint));
  }
  const Prescription& rx = named.prescription;
  Json json = {{"id", case_name(named.id, distance_m, 2.0 * a)},
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
                {{"covariance_rad2", symmetric_json(sin2)},
                 {"semi_axes_rad", semi_axes_json(Ellipse::of_second_moments(sin2))}}},
               {"rays", std::move(rays)}};
  for (const Mutation& mutation : mutations)
    if (Json patch = mutated_case(mutation, bundles, eye, footprint); !patch.is_null())
      json["mutated"][mutation.id] = std::move(patch);
  return json;
}

}  // namespace

Json ellipse_results(const EllipseExperiment& spec, std::uint64_t seed, std::span<const Mutation> mutations,
                     const ProgressFunction& progress) {
  Json cases = Json::array();
  const double total =
      static_cast<double>(spec.prescriptions.size() * spec.distances_m.size() * spec.pupil_diameters_m.size());
  for (const NamedPrescription& named : spec.prescriptions)
    for (double pupil : spec.pupil_diameters_m) {
      const Eye eye = Eye::with(named.prescription, pupil, spec.accommodation);
      for (double distance : spec.distances_m) {
        cases.push_back(case_json(named, distance, eye, spec, seed, mutations));
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
