#pragma once
#include <vector>

#include "io/specs/ellipse_query.h"
#include "io/specs/worn_eye_spec.h"
#include "reports/plots/blur_plot.h"

namespace sturm {

/// The blur ellipses of targets as `sturm ellipse` finds them by the method `conoid`, one for each target.
std::vector<BlurAtDistance> conoid_ellipses(const WornEye& worn, const std::vector<Target>& targets);

}  // namespace sturm
