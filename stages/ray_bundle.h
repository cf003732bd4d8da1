#pragma once
#include <optional>

#include "compare/ellipses/bundle_moments.h"
#include "io/specs/ray_bundle_spec.h"
#include "pathtrace/cameras/ray_model.h"
#include "pathtrace/cameras/worn_lens.h"

namespace sturm {

/// Rays that left the eye but did not come through the spectacles.
struct LensLosses {
  std::uint64_t rim = 0, total_reflection = 0, no_convergence = 0;

  std::uint64_t total() const { return rim + total_reflection + no_convergence; }
  void count(LensStatus status);
  LensLosses& operator+=(const LensLosses& other);
};

/// The pattern that a bundle of rays from the whole pupil makes at one target, as angles [rad] from the chief ray.
struct MeasuredBundle {
  std::optional<BundleEllipse> angular;  ///< none where fewer than two rays of a replicate arrived
  RayCounters counters;
  LensLosses losses;
};

/// Where a ray that leaves the naked eye goes, at vergence 1/d of the target (0 at infinity): p/d + s(p) [rad].
inline Eigen::Vector2d naked_angle(const PupilRay<double>& ray, double target_vergence_D) {
  return {target_vergence_D * ray.px + ray.sx, target_vergence_D * ray.py + ray.sy};
}

/// The lens that the rays go through, and the chief ray that leaves it: origin of distances, and axis of the plane
/// where they are measured.
struct LensView {
  WornLens worn;
  LightRay chief;          ///< from the exit point
  Eigen::Vector3d e1, e2;  ///< across the chief ray

  /// Of an eye that looks along `gaze`; its chief ray must come through. Nothing of it is taken from the conoid.
  static LensView along(const Spectacles& lens, const Eigen::Vector3d& gaze, double rotation_center_m);

  /// Where a ray behind the lens meets the plane at vergence 1/d, as an angle: offset/d on (e1, e2); at infinity the
  /// difference of direction.
  Eigen::Vector2d angle(const LightRay& ray, double vergence_D) const;
};

/// Launches the rays of `eye_rays` through the pupil as `spec` says and measures where they go at vergence 1/d of the
/// target (0 at infinity). Naked eye: angle = p/d + s(p). With a `lens`: through its real surfaces, d from the exit
/// point of the chief ray; rays that it stops are left out and counted. `apodization`: q of the pupil
/// (pathtrace/sampling/pupil_sampler.h), for all but given points. Replicates run in parallel; the result does not
/// depend on the number of threads.
MeasuredBundle measure_bundle(const EyeRays<double>& eye_rays, double target_vergence_D, const RayBundleSpec& spec,
                              std::uint64_t seed, const LensView* lens = nullptr, double apodization = 0.0);

/// The rays of an eye in the state that the target asks for; none where the model has none (has_rays).
std::optional<EyeRays<double>> eye_rays_for(RayModel model, const Eye& eye, double accommodation_D);

}  // namespace sturm
