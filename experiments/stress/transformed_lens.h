#pragma once
#include "lensmodel/spectacles.h"

namespace sturm::stress {

/// The lens turned counter-clockwise (for the wearer) by `angle_deg` about the primary line of sight. A mounted lens is
/// then tilted and wrapped otherwise and turned about its own axis. B-spline surfaces only turn by quarters, and by
/// halves in a mounted lens: the angle is `possible_turn_deg`.
Spectacles turned(const Spectacles& lens, double angle_deg);

/// The angle itself, or the next one that the lens can be turned by, not 0.
double possible_turn_deg(const Spectacles& lens, double angle_deg);

/// All lengths times `scale`.
Spectacles scaled(const Spectacles& lens, double scale);

/// x turned to −x.
Spectacles mirrored(const Spectacles& lens);

}  // namespace sturm::stress
