#pragma once
#include <Eigen/Core>
#include <optional>

#include "conoid/tracing/footprint.h"
#include "conoid/tracing/ray_transfer.h"
#include "lensmodel/eye.h"
#include "lensmodel/light_ray.h"
#include "lensmodel/spectacles.h"

namespace sturm {

/// The conoid of an eye behind a spectacle lens for one direction of gaze, traced once for all distances and all states
/// of accommodation: at the distance d from the exit point a ray that left the pupil at p with the slope S p stands at
/// X p, X(d) = P(d) + Q(d) S.
struct SpectacleConoid {
  LensStatus status = LensStatus::missed_lens;  ///< unless ok, the rest means nothing
  LightRay chief_ray;                           ///< from the exit point on the front surface, wearer frame
  RayTransfer exit;                             ///< from the pupil (turned pupil frame) to the exit point, on (e1, e2)

  /// P and Q divided by d: finite at d = ∞, where they map to angles. `vergence_D` = 1/d.
  Eigen::Matrix2d angular_p(double vergence_D) const {
    return vergence_D * exit.offset_from_offset + exit.slope_from_offset;
  }
  Eigen::Matrix2d angular_q(double vergence_D) const {
    return vergence_D * exit.offset_from_slope + exit.slope_from_slope;
  }  ///< as angular_p

  /// X(d)/d [rad/m] for the slopes S = F − A·I [D].
  Eigen::Matrix2d angular_footprint(const Eigen::Matrix2d& slopes, double vergence_D) const {
    return angular_p(vergence_D) + angular_q(vergence_D) * slopes;
  }

  /// Curvature K = −B A⁻¹ of the wave at the exit point [D] on (e1, e2), positive = converging towards the scene. None
  /// where a focal line passes through the exit point: A is singular to `relative_singularity` of its size.
  std::optional<Eigen::Matrix2d> exit_curvature(const Eigen::Matrix2d& slopes) const;
  static constexpr double relative_singularity = 1e-14;  ///< of |det A| to the sum of the squares of its elements
};

/// Turns the eye to `gaze` (unit vector; Listing's law about its centre of rotation) and follows its chief ray and the
/// rays about it through back and front surface. (e1, e2) is what the smallest rotation taking −z to the outgoing chief
/// ray makes of (x, y).
SpectacleConoid trace_conoid(const Spectacles& spectacles, const Eigen::Vector3d& gaze, double rotation_center_m);

/// The same for any line of sight: rays start on the frame (e1, e2) across `line_of_sight` (unit direction), at its
/// origin.
SpectacleConoid trace_conoid_along(const Spectacles& spectacles, const LightRay& line_of_sight,
                                   const Eigen::Vector3d& e1, const Eigen::Vector3d& e2);

/// The accommodation A [D] in [0, amplitude_D] that makes the larger semi-axis of the footprint at 1/d least
/// (lensmodel/best_accommodation.h).
double best_accommodation(const SpectacleConoid& conoid, const PowerMatrix& correction, double vergence_D,
                          double amplitude_D);

/// The eye's accommodation for a target at 1/d (from the exit point).
double accommodation_through(const SpectacleConoid& conoid, const Eye& eye, double vergence_D);

/// The footprint at one target, `distance_m` > 0 from the exit point along the outgoing chief ray (∞ allowed); status
/// must be ok.
Footprint spectacle_footprint(const SpectacleConoid& conoid, const Eye& eye, double distance_m, double accommodation_D);

}  // namespace sturm
