#pragma once
#include <optional>

#include "lensmodel/power_matrix.h"
#include "lensmodel/spectacles.h"

namespace sturm {

/// What a turned eye gets from its lens along one line of sight.
struct AsWorn {
  LensStatus status = LensStatus::missed_lens;  ///< of the chief ray; unless ok the rest means nothing
  double deviation_rad = 0.0;      ///< angle between the line of sight and the chief ray before the lens, ≥ 0
  std::optional<double> base_deg;  ///< the prism's base, 0 ≤ base < 360, counter-clockwise as an examiner faces the
                                   ///< eye; none without deviation

  /// Vergence [D], positive where it converges, that a distant object on the outgoing chief ray has at the vertex
  /// sphere: on the line of sight, as far from the eye's centre of rotation as the back vertex. On the axes of the
  /// turned eye (Listing). None where a focal line lies on the sphere.
  std::optional<PowerMatrix> power;

  /// Prism [Δ = cm/m].
  double prism_cm_per_m() const;
};

/// The eye looks along `gaze` (unit vector, wearer frame) and turns about the point `rotation_center_m` behind its
/// pupil.
AsWorn as_worn(const Spectacles& lens, const Eigen::Vector3d& gaze, double rotation_center_m);

}  // namespace sturm
