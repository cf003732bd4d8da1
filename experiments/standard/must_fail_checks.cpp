#include "experiments/standard/must_fail_checks.h"

namespace sturm {

namespace {

/// The bound that honest matrix rays keep against the conoid: relative Frobenius error of the covariance.
constexpr double agreement_bound = 0.005;

using WrongReading = Prescription (*)(Prescription);

Prescription mirrored(Prescription rx) {
  rx.axis_deg = folded_axis_deg(180.0 - rx.axis_deg);
  return rx;
}

Prescription at_cornea(Prescription rx) {
  rx.vertex_distance_m = 0.0;
  return rx;
}

Prescription unchanged(Prescription rx) {
  return rx;
}

/// Largest relative error over all cases between the rays of `model` and the conoid of the prescription as `read`.
Number worst_error(std::span<const TracedCase> cases, RayModel model, WrongReading read) {
  Number worst;
  for (const TracedCase& c : cases) {
    const BundleEllipse* measured = c.ellipse_of(model);
    const Eye eye = Eye::with(read(c.eye.prescription), 2.0 * c.eye.pupil_radius_m, c.eye.accommodation);
    const Footprint f = naked_eye_footprint(eye, c.footprint.distance_m);
    const Eigen::Matrix2d predicted = covariance_of_disc_image(f.angular, eye.pupil_radius_m);
    if (!measured || !(predicted.norm() > 0.0)) continue;
    const double error = (measured->covariance - predicted).norm() / predicted.norm();
    if (!worst || error > *worst) worst = error;
  }
  return worst;
}

MutantFinding mutant(const char* id, const char* what, const Number& value) {
  return {.id = id,
          .what = what,
          .failed_as_it_must = value && *value > agreement_bound,
          .value = value,
          .bound = agreement_bound};
}

}  // namespace

std::vector<MutantFinding> must_fail_checks(std::span<const TracedCase> cases) {
  return {mutant("mirrored_axis", "the conoid was given AXIS 180 − α instead of α; matrix rays were not",
                 worst_error(cases, RayModel::power_matrix, mirrored)),
          mutant("dropped_vertex_distance",
                 "the conoid was given the spectacle prescription as if written at the cornea; matrix rays were not",
                 worst_error(cases, RayModel::power_matrix, at_cornea)),
          mutant("meridional_as_matrix", "sin² rays were passed off as matrix rays",
                 worst_error(cases, RayModel::sin2_radial, unchanged))};
}

}  // namespace sturm
