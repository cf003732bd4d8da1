#pragma once
#include <array>

#include "experiments/stress/oracle.h"

namespace sturm::stress {

/// Rounding of double.
inline constexpr double unit_roundoff = 0x1p-53;

/// Every short formula of the program is charged with this relative error: at most 16 roundings.
inline constexpr double formula_error = 16.0 * unit_roundoff;

/// How far first order in double may be from the exact one: a running error analysis along the chief ray
/// (docs/theory.md#117-numerical-stability). Everything is proportional to `formula_error`; conditioning (1/cos at each
/// surface, the surface's steepness, the ray transfer itself) comes from the extended-precision trace, no number is
/// fitted.
struct ErrorBounds {
  double exit_point = 0.0, direction = 0.0;  ///< [m], [rad]
  double offset_p = 0.0, offset_q = 0.0;     ///< of the blocks by pupil offset (p) and slope (q), Frobenius: [1], [m]
  double slope_p = 0.0, slope_q = 0.0;       ///< [1/m], [1]
  std::array<double, 2> hit{}, cos_in{}, radicand{};  ///< of the two surfaces: hit point [m], cos φ, 1 − μ² sin²φ

  /// Of X(d)/d for slopes of norm `slopes`.
  double angular_footprint(double slopes, double vergence_D) const {
    return vergence_D * (offset_p + offset_q * slopes) + slope_p + slope_q * slopes;
  }
};

/// Bounds as far as the trace came; `trace` may have been lost on the way.
ErrorBounds error_bounds(const Spectacles& lens, double rotation_center_m, const ExtendedTrace& trace);

struct BlockBounds {
  double offset_p, offset_q;  ///< [1], [m]
  double slope_p, slope_q;    ///< [1/m], [1]
};

/// How far a chain is from the exact one with the same points, cosines, frames and curvatures: only its own products
/// and sums are rounded. Of a trace that came through.
BlockBounds split_bounds(const ExtendedTrace& trace);

}  // namespace sturm::stress
