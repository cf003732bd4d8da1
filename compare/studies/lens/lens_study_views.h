#pragma once
#include <set>
#include <string>

#include "compare/studies/lens/lens_findings.h"

namespace sturm {

/// Views whose larger principal blur is below this have a first order that is nearly zero, and no relative error that
/// means anything.
inline constexpr double least_blur_D = 0.5;

/// Ids of the lenses with a spline surface, where orders hold only roughly. A report that does not say has none.
std::set<std::string> spline_lenses(const LensFindings& found);

/// "P195-OD|20° 45°|0.25 m": lens, eccentricity and direction of the gaze, distance.
std::string view_name(const LensStudyView& view);

}  // namespace sturm
