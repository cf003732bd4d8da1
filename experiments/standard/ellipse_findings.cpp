#include "experiments/standard/ellipse_findings.h"

#include "compare/ellipses/ellipse_comparison.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

/// From the measure's unit to that of the finding.
std::optional<EllipseMeasure> scaled(const std::optional<EllipseMeasure>& m, double scale) {
  if (!m) return std::nullopt;
  return EllipseMeasure{scale * m->value, m->standard_error ? Number(scale * *m->standard_error) : std::nullopt, m->z};
}

EllipseDifferences differences_of(const EllipseMeasures& m) {
  constexpr double arcmin = arcminutes_per_radian;
  return {.semi_major_arcmin = scaled(m.semi_major, arcmin),
          .semi_minor_arcmin = scaled(m.semi_minor, arcmin),
          .orientation_deg = m.orientation,
          .log_area_ratio = m.log_area_ratio,
          .frobenius_arcmin2 = scaled(m.frobenius, arcmin * arcmin),
          .bures_wasserstein_arcmin = scaled(m.bures_wasserstein, arcmin),
          .missing_overlap = m.missing_overlap};
}

EllipseAgreement agreement_of(const EllipseComparison& c) {
  return {c.z_max, c.relative_frobenius};
}

/// Without the measures that take a bootstrap.
ConoidComparison compared(const BundleEllipse& measured, const Eigen::Matrix2d& conoid) {
  const EllipseComparison c = compare_to_prediction(measured, conoid);
  return {.agreement = agreement_of(c),
          .differences = std::nullopt,
          .semi_axis_errors = {c.semi_major_relative_error, c.semi_minor_relative_error},
          .minor_axis_error_arcmin = c.semi_minor_error * arcminutes_per_radian,
          .orientation_error_deg = c.orientation_error_deg,
          .bures_wasserstein_arcmin = c.bures_wasserstein * arcminutes_per_radian};
}

/// What both closed forms say of a case.
struct Predictions {
  Eigen::Matrix2d conoid, sin2;

  Predictions(const Footprint& conoid_of, const Footprint& sin2_of, double pupil_radius_m)
      : conoid(covariance_of_disc_image(conoid_of.angular, pupil_radius_m)),
        sin2(sin2_closed_form_covariance(sin2_of.angular, pupil_radius_m)) {}
};

/// The rays of one model against both, `passed_off_as` those of a model that they need not be of.
RayFinding rays_against(const Predictions& predicted, const TracedRays& traced, RayModel passed_off_as) {
  RayFinding finding;
  finding.model = passed_off_as;
  finding.status = RayStatus::Undefined;
  if (!traced.bundle) return finding;
  const RayCounters& counters = traced.bundle->counters;
  finding.counts = RayCounts{counters.launched, counters.dropped, counters.negative_focus};
  const BundleEllipse* measured = traced.ellipse();
  if (!measured) return finding;
  finding.status = RayStatus::Ok;
  finding.ellipse = measured->ellipse;
  finding.covariance_rad2 = measured->covariance;
  finding.covariance_standard_error_rad2 = measured->covariance_standard_error();
  finding.against_conoid = compared(*measured, predicted.conoid);
  if (passed_off_as == RayModel::sin2_radial)
    finding.against_closed_form = agreement_of(compare_to_prediction(*measured, predicted.sin2));
  return finding;
}

void predict(const Footprint& conoid_of, const Predictions& predicted, double pupil_radius_m, EllipseFinding& finding) {
  finding.conoid = {Ellipse::image_of_disc(conoid_of.angular, pupil_radius_m), predicted.conoid};
  finding.sin2_closed_form = {Ellipse::of_second_moments(predicted.sin2), predicted.sin2};
}

EllipseFinding finding_of(const TracedCase& c) {
  const Prescription& rx = c.eye.prescription;
  const double a = c.eye.pupil_radius_m;
  const Predictions predicted(c.footprint, c.footprint, a);
  EllipseFinding finding;
  finding.id = c.id;
  finding.prescription = c.prescription;
  finding.sphere_D = rx.sphere_D;
  finding.cylinder_D = rx.cylinder_D;
  finding.axis_deg = rx.axis_deg;
  finding.vertex_distance_mm = 1e3 * rx.vertex_distance_m;
  finding.distance_m = c.footprint.distance_m;
  finding.pupil_mm = 2e3 * a;
  finding.accommodation_D = c.footprint.accommodation_D;
  predict(c.footprint, predicted, a, finding);
  for (const TracedRays& traced : c.rays) {
    finding.rays.push_back(rays_against(predicted, traced, traced.model));
    if (const BundleEllipse* measured = traced.ellipse())
      finding.rays.back().against_conoid->differences = differences_of(measure_ellipses(*measured, predicted.conoid));
  }
  return finding;
}

/// What a mutation makes of a case, without the measures that no gate looks at; none where it is none of ellipses. The
/// closed form of sin², which is no ellipse of the conoid's, follows a wrong prescription but not a wrong semi-axis.
std::optional<EllipseFinding> mutated(const EllipseFinding& honest, const TracedCase& c, const Mutation& mutation) {
  const std::optional<Footprint> wrong = mutated_footprint(mutation, c.eye, c.footprint);
  const bool dropped = std::holds_alternative<mutation::DroppedTangentialTerm>(mutation.kind);
  if (!wrong && !dropped) return std::nullopt;
  const Footprint& conoid_of = wrong ? *wrong : c.footprint;
  const bool other_eye = std::holds_alternative<mutation::WrongPrescription>(mutation.kind);
  const Predictions predicted(conoid_of, other_eye ? conoid_of : c.footprint, c.eye.pupil_radius_m);
  EllipseFinding finding = honest;
  predict(conoid_of, predicted, c.eye.pupil_radius_m, finding);
  finding.rays.clear();
  for (const TracedRays& traced : c.rays) {
    if (dropped && traced.model == RayModel::sin2_radial)
      finding.rays.push_back(rays_against(predicted, traced, RayModel::power_matrix));
    if (!dropped || traced.model != RayModel::power_matrix)
      finding.rays.push_back(rays_against(predicted, traced, traced.model));
  }
  return finding;
}

}  // namespace

EllipseFindings ellipse_findings(const EllipseExperiment& spec, std::span<const TracedCase> cases,
                                 std::span<const Mutation> mutations) {
  const bool sobol = spec.rays.sequence == Sequence::Sobol;
  EllipseFindings findings{.conditions = {.rays_per_replicate = spec.rays.count,
                                          .replicates = spec.rays.replicates,
                                          .sampling = "uniform_disk",
                                          .sequence = sobol ? "sobol" : "independent",
                                          .standard_error = "scatter between replicates / sqrt(replicates)"},
                           .cases = {}};
  for (const TracedCase& c : cases) {
    const EllipseFinding honest = finding_of(c);
    findings.cases.push_back(honest);
    for (const Mutation& mutation : mutations)
      if (auto other = mutated(honest, c, mutation))
        findings.cases.back().mutated.emplace(mutation.id, std::move(*other));
  }
  return findings;
}

}  // namespace sturm
