#include "compare/findings/ellipses.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/json/stored.h"
#include "io/json/stored_values.h"
#include "io/json/values.h"

namespace sturm {

namespace {

Json json_of(const std::optional<EllipseAgreement>& a) {
  if (!a) return nullptr;
  return {{"z_max", number_or_null(a->z_max)}, {"relative_frobenius", number_or_null(a->relative_frobenius)}};
}

Json json_of(const std::optional<EllipseMeasure>& m) {
  if (!m) return nullptr;
  return {{"value", number_or_null(m->value)},
          {"standard_error", number_or_null(m->standard_error)},
          {"z", number_or_null(m->z)}};
}

Json json_of(const std::optional<EllipseDifferences>& d) {
  if (!d) return nullptr;
  return {{"semi_major_arcmin", json_of(d->semi_major_arcmin)},
          {"semi_minor_arcmin", json_of(d->semi_minor_arcmin)},
          {"orientation_deg", json_of(d->orientation_deg)},
          {"log_area_ratio", json_of(d->log_area_ratio)},
          {"frobenius_arcmin2", json_of(d->frobenius_arcmin2)},
          {"bures_wasserstein_arcmin", json_of(d->bures_wasserstein_arcmin)},
          {"missing_overlap", json_of(d->missing_overlap)}};
}

Json json_of(const std::optional<ConoidComparison>& c) {
  if (!c) return nullptr;
  Json json = json_of(std::optional(c->agreement));
  json.update({{"measures", json_of(c->differences)},
               {"semi_axis_errors", {number_or_null(c->semi_axis_errors[0]), number_or_null(c->semi_axis_errors[1])}},
               {"minor_axis_error_arcmin", number_or_null(c->minor_axis_error_arcmin)},
               {"orientation_error_deg", number_or_null(c->orientation_error_deg)},
               {"bures_wasserstein_arcmin", number_or_null(c->bures_wasserstein_arcmin)}});
  return json;
}

Json semi_axes_or_null(const std::optional<Ellipse>& e) {
  return e ? pair_or_null(Eigen::Vector2d(e->semi_major, e->semi_minor)) : Json(nullptr);
}

Json orientation_or_null(const std::optional<Ellipse>& e) {
  return e ? number_or_null(e->orientation_deg) : Json(nullptr);
}

Json json_of(const RayFinding& rays) {
  Json json = {{"ray_model", name_of(rays.model)},
               {"status", rays.status ? Json(ray_status_words.word_of(*rays.status)) : Json(nullptr)},
               {"semi_axes_rad", semi_axes_or_null(rays.ellipse)},
               {"orientation_deg", orientation_or_null(rays.ellipse)},
               {"covariance_rad2", symmetric_or_null(rays.covariance_rad2)},
               {"covariance_standard_error_rad2", triple_or_null(rays.covariance_standard_error_rad2)},
               {"against_conoid", json_of(rays.against_conoid)},
               {"against_closed_form", json_of(rays.against_closed_form)}};
  if (rays.counts)
    json["counters"] = {{"launched", rays.counts->launched},
                        {"dropped", rays.counts->dropped},
                        {"negative_focus", rays.counts->negative_focus}};
  return json;
}

std::optional<EllipseAgreement> agreement_from(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  return EllipseAgreement{number_at(json, "z_max"), number_at(json, "relative_frobenius")};
}

std::optional<EllipseMeasure> measure_at(const Json& json, const char* key) {
  const Json& m = value_at(json, key);
  const Number value = number_at(m, "value");
  if (!value) return std::nullopt;
  return EllipseMeasure{*value, number_at(m, "standard_error"), number_at(m, "z")};
}

std::optional<EllipseDifferences> differences_from(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  return EllipseDifferences{.semi_major_arcmin = measure_at(json, "semi_major_arcmin"),
                            .semi_minor_arcmin = measure_at(json, "semi_minor_arcmin"),
                            .orientation_deg = measure_at(json, "orientation_deg"),
                            .log_area_ratio = measure_at(json, "log_area_ratio"),
                            .frobenius_arcmin2 = measure_at(json, "frobenius_arcmin2"),
                            .bures_wasserstein_arcmin = measure_at(json, "bures_wasserstein_arcmin"),
                            .missing_overlap = measure_at(json, "missing_overlap")};
}

std::optional<ConoidComparison> conoid_comparison_from(const Json& json) {
  const std::optional<EllipseAgreement> agreement = agreement_from(json);
  if (!agreement) return std::nullopt;
  return ConoidComparison{
      .agreement = *agreement,
      .differences = differences_from(value_at(json, "measures")),
      .semi_axis_errors = {number_at(json, "semi_axis_errors/0"), number_at(json, "semi_axis_errors/1")},
      .minor_axis_error_arcmin = number_at(json, "minor_axis_error_arcmin"),
      .orientation_error_deg = number_at(json, "orientation_error_deg"),
      .bures_wasserstein_arcmin = number_at(json, "bures_wasserstein_arcmin")};
}

std::optional<Ellipse> ellipse_in_radians(const Json& json) {
  const std::optional<Eigen::Vector2d> axes = pair_at(json, "semi_axes_rad");
  if (!axes) return std::nullopt;
  return Ellipse{axes->x(), axes->y(), number_at(json, "orientation_deg")};
}

std::optional<RayCounts> counts_from(const Json& json) {
  const auto launched = count_at(json, "launched"), dropped = count_at(json, "dropped"),
             negative = count_at(json, "negative_focus");
  return launched && dropped && negative ? std::optional(RayCounts{*launched, *dropped, *negative}) : std::nullopt;
}

RayFinding rays_from(const Json& json) {
  return {.model = ray_model_at(json, "ray_model"),
          .status = ray_status_words.value_of(text_at(json, "status")),
          .counts = counts_from(value_at(json, "counters")),
          .ellipse = ellipse_in_radians(json),
          .covariance_rad2 = symmetric_at(json, "covariance_rad2"),
          .covariance_standard_error_rad2 = triple_at(json, "covariance_standard_error_rad2"),
          .against_conoid = conoid_comparison_from(value_at(json, "against_conoid")),
          .against_closed_form = agreement_from(value_at(json, "against_closed_form"))};
}

PredictedEllipse predicted_from(const Json& json) {
  return {ellipse_in_radians(json), symmetric_at(json, "covariance_rad2")};
}

EllipseFinding ellipse_finding_from(const Json& json) {
  EllipseFinding finding{.id = text_at(json, "id"),
                         .prescription = text_at(json, "prescription"),
                         .sphere_D = number_at(json, "sphere_D"),
                         .cylinder_D = number_at(json, "cylinder_D"),
                         .axis_deg = number_at(json, "axis_deg"),
                         .vertex_distance_mm = number_at(json, "vertex_distance_mm"),
                         .distance_m = distance_at(json, "distance_m"),
                         .pupil_mm = number_at(json, "pupil_mm"),
                         .accommodation_D = number_at(json, "accommodation_D"),
                         .conoid = predicted_from(value_at(json, "conoid")),
                         .sin2_closed_form = predicted_from(value_at(json, "sin2_closed_form")),
                         .rays = {},
                         .mutated = {}};
  for (const Json& rays : array_at(json, "rays")) finding.rays.push_back(rays_from(rays));
  return finding;
}

}  // namespace

EllipseAgreement RayFinding::own_agreement() const {
  if (against_closed_form) return *against_closed_form;
  return against_conoid ? against_conoid->agreement : EllipseAgreement{};
}

const RayFinding* EllipseFinding::rays_of(RayModel model) const {
  const auto found = std::find_if(rays.begin(), rays.end(), [&](const RayFinding& r) { return r.model == model; });
  return found == rays.end() ? nullptr : &*found;
}

Number EllipseFinding::predicted_difference() const {
  const auto &of = sin2_closed_form.covariance_rad2, &from = conoid.covariance_rad2;
  if (!of || !from) return std::nullopt;
  double difference = 0.0, norm = 0.0;
  for (const auto& [i, j] : {std::pair(0, 0), {0, 1}, {1, 1}}) {
    const double a = (*of)(i, j), b = (*from)(i, j), weight = i == j ? 1.0 : 2.0;
    difference += weight * (a - b) * (a - b);
    norm += weight * b * b;
  }
  return norm > 0.0 ? Number(std::sqrt(difference / norm)) : std::nullopt;
}

Json to_json(const EllipseFinding& finding) {
  Json rays = Json::array();
  for (const RayFinding& of_model : finding.rays) rays.push_back(json_of(of_model));
  const PredictedEllipse &conoid = finding.conoid, &sin2 = finding.sin2_closed_form;
  Json json = {{"id", finding.id},
               {"prescription", finding.prescription},
               {"sphere_D", number_or_null(finding.sphere_D)},
               {"cylinder_D", number_or_null(finding.cylinder_D)},
               {"axis_deg", number_or_null(finding.axis_deg)},
               {"vertex_distance_mm", number_or_null(finding.vertex_distance_mm)},
               {"distance_m", distance_or_null(finding.distance_m)},
               {"pupil_mm", number_or_null(finding.pupil_mm)},
               {"accommodation_D", number_or_null(finding.accommodation_D)},
               {"conoid",
                {{"semi_axes_rad", semi_axes_or_null(conoid.ellipse)},
                 {"orientation_deg", orientation_or_null(conoid.ellipse)},
                 {"covariance_rad2", symmetric_or_null(conoid.covariance_rad2)}}},
               {"sin2_closed_form",
                {{"covariance_rad2", symmetric_or_null(sin2.covariance_rad2)},
                 {"semi_axes_rad", semi_axes_or_null(sin2.ellipse)}}},
               {"rays", std::move(rays)}};
  for (const auto& [mutation, other] : finding.mutated) json["mutated"][mutation] = to_json(other);
  return json;
}

Json to_json(const EllipseFindings& findings) {
  Json cases = Json::array();
  for (const EllipseFinding& finding : findings.cases) cases.push_back(to_json(finding));
  const EllipseConditions& c = findings.conditions;
  return {{"conditions",
           {{"rays_per_replicate", count_or_null(c.rays_per_replicate)},
            {"replicates", count_or_null(c.replicates)},
            {"sampling", c.sampling},
            {"sequence", c.sequence},
            {"standard_error", c.standard_error}}},
          {"cases", std::move(cases)}};
}

EllipseFindings read_ellipses(const Json& report) {
  const Json &section = value_at(report, "ellipses"), &conditions = value_at(section, "conditions");
  EllipseFindings findings{.conditions = {.rays_per_replicate = count_at(conditions, "rays_per_replicate"),
                                          .replicates = count_at(conditions, "replicates"),
                                          .sampling = text_at(conditions, "sampling"),
                                          .sequence = text_at(conditions, "sequence"),
                                          .standard_error = text_at(conditions, "standard_error")},
                           .cases = {}};
  for (const Json& item : array_at(section, "cases")) findings.cases.push_back(ellipse_finding_from(item));
  return findings;
}

}  // namespace sturm
