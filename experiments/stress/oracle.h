#pragma once
#include <array>
#include <optional>

#include "experiments/stress/extended.h"
#include "experiments/stress/surface_shape.h"
#include "lensmodel/spectacles.h"

namespace sturm::stress {

/// One surface on the chief ray's way, as the error model wants it. Norms are Frobenius; "in" is just before the
/// surface, across the ray.
struct Crossing {
  double path_m = 0.0;                                           ///< from the point before
  double cos_in = 1.0, cos_out = 1.0, radicand = 1.0, mu = 1.0;  ///< radicand: 1 − μ² sin²φ; ≤ 0 is total reflection
  double x = 0.0, y = 0.0, z = 0.0;                              ///< where, surface frame [m]
  bool on_sheet = false;                                         ///< else the shape means nothing
  SurfaceShape shape;                                            ///< there
  double offset_p_in = 0.0, offset_q_in = 0.0, slope_p_in = 0.0, slope_q_in = 0.0;
  double offset_p_out = 0.0, offset_q_out = 0.0, slope_p_out = 0.0, slope_q_out = 0.0;
};

using ExtendedMatrix = std::array<std::array<Extended, 2>, 2>;

/// The chief ray and its neighbourhood in extended precision: real rays, differentiated. It shares the description of
/// lens and eye with the program, no formula of surfaces, of ray transfer or of waves.
struct ExtendedTrace {
  LensStatus status = LensStatus::missed_lens;
  int crossings = 0;  ///< surfaces that were met
  std::array<Crossing, 2> at;
  Vec3<Extended> exit_point{}, direction{};
  Frame frame{};
  /// Derivatives of offset and slope on `frame` by pupil offset (columns 0, 1) and slope (2, 3), from the exit point.
  std::array<std::array<Extended, 4>, 2> offset{}, slope{};

  /// X(d)/d for the slopes S at 1/d.
  ExtendedMatrix angular_footprint(const Eigen::Matrix2d& slopes, double vergence_D) const;

  /// K = −B A⁻¹ of a bundle with the slopes S; none where A is singular.
  std::optional<ExtendedMatrix> exit_curvature(const Eigen::Matrix2d& slopes) const;
};

/// Points where the ray is known to meet back and front, to start Newton's iteration from; their accuracy does not
/// matter.
struct StartingPoints {
  Eigen::Vector3d back, front;  ///< wearer frame
};

/// Follows the eye's chief ray of the gaze, a vector of length 1 but for rounding. Without starting points each surface
/// is searched along the whole ray, for rays of which the program says that they are lost. `no_convergence`: Newton's
/// iteration did not settle to 2^-58.
ExtendedTrace trace_extended(const Spectacles& lens, const Eigen::Vector3d& gaze, double rotation_center_m,
                             const std::optional<StartingPoints>& start);

}  // namespace sturm::stress
