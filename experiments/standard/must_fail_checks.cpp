#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "conoid/tracing/footprint.h"
#include "experiments/run/sections.h"
#include "io/json/values.h"

namespace sturm {

namespace {

/// The bound that honest matrix rays keep against the conoid: relative Frobenius error of the covariance.
constexpr double agreement_bound = 0.005;

using Mutation = std::function<Prescription(Prescription)>;

/// Largest relative error over all cases between the rays of `ray_model` and the conoid of the mutated prescription.
Json worst_error(const EllipseExperiment& spec, const Json& ellipses, const std::string& ray_model,
                 const Mutation& mutate) {
  Json worst = nullptr;
  auto entry = ellipses.at("cases").begin();
  // The cases of the section stand in the order in which they were computed.
  for (const NamedPrescription& named : spec.prescriptions)
    for (double pupil : spec.pupil_diameters_m) {
      const Eye eye = Eye::with(mutate(named.prescription), pupil, spec.accommodation);
      for (double distance : spec.distances_m) {
        const Footprint f = naked_eye_footprint(eye, distance);
        const Eigen::Matrix2d predicted = covariance_of_disc_image(f.angular, eye.pupil_radius_m);
        for (const Json& rays : entry->at("rays")) {
          if (rays.at("ray_model") != ray_model || rays.at("status") != "ok" || !(predicted.norm() > 0.0)) continue;
          const double error = (symmetric_from(rays.at("covariance_rad2")) - predicted).norm() / predicted.norm();
          if (worst.is_null() || error > worst.get<double>()) worst = error;
        }
        ++entry;
      }
    }
  return worst;
}

Json entry(const char* id, const char* what, const Json& value) {
  const bool noticed = value.is_number() && value.get<double>() > agreement_bound;
  return {{"id", id}, {"what", what}, {"failed_as_it_must", noticed}, {"value", value}, {"bound", agreement_bound}};
}

}  // namespace

Json must_fail_checks(const EllipseExperiment& spec, const Json& ellipses) {
  const auto mirrored = [](Prescription rx) {
    rx.axis_deg = folded_axis_deg(180.0 - rx.axis_deg);
    return rx;
  };
  const auto at_cornea = [](Prescription rx) {
    rx.vertex_distance_m = 0.0;
    return rx;
  };
  const auto unchanged = [](const Prescription& rx) { return rx; };
  return {entry("mirrored_axis", "the conoid was given AXIS 180 − α instead of α; matrix rays were not",
                worst_error(spec, ellipses, "power_matrix", mirrored)),
          entry("dropped_vertex_distance",
                "the conoid was given the spectacle prescription as if written at the cornea; matrix rays were not",
                worst_error(spec, ellipses, "power_matrix", at_cornea)),
          entry("meridional_as_matrix", "sin² rays were passed off as matrix rays",
                worst_error(spec, ellipses, "sin2_radial", unchanged))};
}

}  // namespace sturm
