#include "experiments/standard/traced_cases.h"

#include <cmath>
#include <cstdio>

#include "lensmodel/units.h"

namespace sturm {

namespace {

std::string case_name(const std::string& prescription, double distance_m, double pupil_diameter_m) {
  char distance[32], pupil[32];
  if (std::isinf(distance_m))
    std::snprintf(distance, sizeof distance, "inf");
  else
    std::snprintf(distance, sizeof distance, "%g m", distance_m);
  std::snprintf(pupil, sizeof pupil, "%g mm", 1e3 * pupil_diameter_m);
  return prescription + "|" + distance + "|" + pupil;
}

TracedCase traced(const NamedPrescription& named, const Eye& eye, double distance_m, const EllipseExperiment& spec,
                  std::uint64_t seed) {
  TracedCase result{.id = case_name(named.id, distance_m, 2.0 * eye.pupil_radius_m),
                    .prescription = named.id,
                    .eye = eye,
                    .footprint = naked_eye_footprint(eye, distance_m),
                    .rays = {}};
  for (const RayModel model : spec.ray_models) {
    TracedRays rays{model, std::nullopt};
    if (const auto eye_rays = eye_rays_for(model, eye, result.footprint.accommodation_D))
      rays.bundle = measure_bundle(*eye_rays, vergence_of(distance_m), spec.rays, seed);
    result.rays.push_back(std::move(rays));
  }
  return result;
}

}  // namespace

const BundleEllipse* TracedCase::ellipse_of(RayModel model) const {
  for (const TracedRays& of_model : rays)
    if (of_model.model == model) return of_model.ellipse();
  return nullptr;
}

std::vector<TracedCase> traced_cases(const EllipseExperiment& spec, std::uint64_t seed,
                                     const ProgressFunction& progress) {
  std::vector<TracedCase> cases;
  const double total =
      static_cast<double>(spec.prescriptions.size() * spec.distances_m.size() * spec.pupil_diameters_m.size());
  for (const NamedPrescription& named : spec.prescriptions)
    for (const double pupil : spec.pupil_diameters_m) {
      const Eye eye = Eye::with(named.prescription, pupil, spec.accommodation);
      for (const double distance : spec.distances_m) {
        cases.push_back(traced(named, eye, distance, spec, seed));
        progress(static_cast<double>(cases.size()) / total);
      }
    }
  return cases;
}

}  // namespace sturm
