#pragma once
#include <string>

#include "io/specs/worn_eye_spec.h"
#include "reports/plots/blur_plot.h"

namespace sturm {

/// The blur up to which vision counts as clear: that of so many dioptres out of focus, as the long semi-axis of an eye
/// with this pupil [arcmin].
double clear_semi_axis_arcmin(const Eye& eye, double clear_D);

/// The blur of a worn eye straight ahead (conoid) for targets from infinity to `nearest_m` in equal steps of vergence,
/// and where it is clear, to 1e-6 D. An interval that is clear to `nearest_m` is followed beyond it.
BlurCurve blur_curve(const WornEye& worn, const std::string& name, double nearest_m, double clear_D);

}  // namespace sturm
