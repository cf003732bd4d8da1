#pragma once
#include "compare/findings/measurement.h"
#include "io/json/json.h"

namespace sturm {

/// Section "depth_psf_study". All its numbers are statistics by themselves: `depth_psf_study/map/LIGHT/PUPIL_MM`, the
/// largest total variation between rays and waves over all vergence errors; `depth_psf_study/eyes/ID/median_D` and
/// `…/share_above_step` of what a table of eyes has beyond second order; and, of a slanted surface with its planes so
/// many pixels apart, `depth_psf_study/banding/WEIGHTS/PARTS/SPACING/rmse` and `…/step`. No seed has a part in any.
void measure_depth_psf_study(const Json& report, Measurements& out);

}  // namespace sturm
