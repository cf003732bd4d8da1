#pragma once
#include <optional>

#include "compare/bundle_moments.h"
#include "io/ray_bundle_spec.h"
#include "pathtrace/ray_model.h"

namespace sturm {

/// The pattern that a bundle of rays from the whole pupil makes at one target, as angles [rad] from the chief ray.
struct MeasuredBundle {
  std::optional<BundleEllipse> angular;  ///< none where fewer than two rays of a replicate could be launched
  RayCounters counters;
};

/// Launches the rays of `eye_rays` through the pupil as `spec` says and measures where they go at vergence 1/d of the target
/// (0 at infinity): angle = p/d + s(p). Replicates run in parallel; the result does not depend on the number of threads.
MeasuredBundle measure_bundle(const EyeRays<double>& eye_rays, double target_vergence_D, const RayBundleSpec& spec, std::uint64_t seed);

/// The rays of an eye in the state that the target asks for. None where the model is undefined: metalstigmatism without a focus distance.
std::optional<EyeRays<double>> eye_rays_for(RayModel model, const Eye& eye, double accommodation_D);

}  // namespace sturm
