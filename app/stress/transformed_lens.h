#pragma once
#include "lensmodel/spectacles.h"

namespace sturm::stress {

/// The lens turned counter-clockwise (for the wearer) by `angle_deg` about its axis.
Spectacles turned(const Spectacles& lens, double angle_deg);

/// All lengths times `scale`.
Spectacles scaled(const Spectacles& lens, double scale);

/// x turned to −x.
Spectacles mirrored(const Spectacles& lens);

}  // namespace sturm::stress
