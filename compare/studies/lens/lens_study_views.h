#pragma once
#include <set>
#include <string>

#include "io/json/json.h"

namespace sturm {

/// Views whose larger principal blur is below this have a first order that is nearly zero, and no relative error that
/// means anything.
inline constexpr double least_blur_D = 0.5;

/// Ids of the lenses with a spline surface, where orders hold only roughly. A section that does not say has none.
std::set<std::string> spline_lenses(const Json& section);

/// "P195-OD|20° 45°|0.25 m": lens, eccentricity and direction of the gaze, distance.
std::string view_name(const Json& view);

}  // namespace sturm
