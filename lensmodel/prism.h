#pragma once
#include "lensmodel/spectacles.h"

namespace sturm {

/// How far the slope of the deviated ray may be from the prism that was asked for, by rounding.
inline constexpr double prism_accuracy = 1e-14;

/// The lens with its back surface wedged so that a ray that leaves the eye along the lens's axis through the back
/// vertex is deviated by `prism_cm_per_m` ≥ 0 [Δ = cm/m] towards the base (as it is light from outside too).
/// `base_deg`: counter-clockwise as an examiner faces the eye: 0 is the examiner's right, the wearer's left; 90 is up.
/// Exact, by tracing; a wedge that the lens had is replaced. Throws std::domain_error where no such wedge exists: the
/// ray is lost, or an index of 1 deviates nothing.
Spectacles with_prism(const Spectacles& lens, double prism_cm_per_m, double base_deg);

}  // namespace sturm
