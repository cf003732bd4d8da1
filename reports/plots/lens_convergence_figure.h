#pragma once
#include <optional>

#include "compare/studies/lens/lens_findings.h"
#include "reports/plots/figure.h"

namespace sturm {

/// ‖C − a²/4 X Xᵀ‖_F against the pupil, logarithmic: ray transfer for every lens (slope 4), the methods with a
/// first-order error for one of them (slope 2). Per lens the oblique view with the largest error. None without views.
std::optional<Figure> convergence_figure(const LensFindings& found);

}  // namespace sturm
