#pragma once
#include <optional>

#include "conoid/tracing/turned_eye.h"

namespace sturm {

/// The distances along one line of sight at which blur stays within a limit.
struct ClearVision {
  double best_vergence_D;      ///< where the larger semi-axis of the blur ellipse is least, within 0 … nearest_D
  double best_semi_major_rad;  ///< and how large it is there
  struct Interval {
    double far_vergence_D, near_vergence_D;
  };
  std::optional<Interval> interval;  ///< none where even the best is beyond the limit
};

/// Nothing nearer is looked at [D].
inline constexpr double nearest_clear_D = 100.0;

/// Where the larger angular semi-axis [rad] is at most `limit_rad`, with the accommodation that the eye takes at each
/// distance. The interval is the one about the best distance; it ends at infinity (0) and at `nearest_clear_D`. Ends
/// are exact to 1e-9 D. The eye's status must be ok.
///
/// The larger semi-axis is a norm of a map that is affine in the vergence, so it is convex for a relaxed and a fixed
/// eye, and for a naked eye that accommodates best.
ClearVision clear_vision(const TurnedEye& eye, double pupil_radius_m, double limit_rad);

}  // namespace sturm
