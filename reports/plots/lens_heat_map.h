#pragma once
#include "compare/studies/lens/lens_study_errors.h"
#include "reports/plots/figure.h"

namespace sturm {

/// Error against real rays [D] of one lens by eccentricity of the gaze and pupil, a panel per method; the worst of all
/// directions and distances. The colour is logarithmic from 0.001 D to 1 D, the number stands in the cell, framed from
/// 0.05 D on.
Figure heat_map(const LensStudyErrors& errors, const std::string& lens);

}  // namespace sturm
