#pragma once
#include <string>

#include "lensmodel/eye.h"
#include "reports/plots/lens_map.h"

namespace sturm {

/// The wavefront W of the relaxed eye over its pupil [µm] as the wearer looks out; of an eye without a measured one
/// that of its power. Positive where the light that leaves the eye is ahead. Piston and tilt are left out. Throws
/// std::invalid_argument for a pinhole.
LensMap wavefront_map(const Eye& eye, const std::string& name);

}  // namespace sturm
