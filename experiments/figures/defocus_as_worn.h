#pragma once
#include <optional>

#include "lensmodel/power_matrix.h"
#include "lensmodel/spectacles.h"

namespace sturm {

/// What an eye has too much behind its lens at one gaze [D], after it has accommodated.
struct DefocusAsWorn {
  double mean_D;    ///< positive: too much power for the target; exactly 0 within the range of accommodation
  double larger_D;  ///< size of the larger principal value: the longest diameter of the blur per pupil diameter
};

/// The vergence that arrives at the pupil from a target at `distance_m` (∞ allowed) from the front surface along the
/// chief ray, minus the vergence that an eye with this correction at its cornea needs. The eye takes the A in [0,
/// amplitude] that brings the mean as near to 0 as possible. None where the lens stops the chief ray or a focal line
/// lies in the pupil.
std::optional<DefocusAsWorn> defocus_as_worn(const Spectacles& lens, const PowerMatrix& correction,
                                             const Eigen::Vector3d& gaze, double rotation_center_m, double distance_m,
                                             double amplitude_D);

}  // namespace sturm
