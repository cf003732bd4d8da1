#pragma once
#include <vector>

#include "compare/studies/lens/lens_findings.h"
#include "reports/plots/figure.h"

namespace sturm {

/// The pictures of a report's section "lens_study": convergence of the absolute error with the pupil, the wide field
/// (curves, and ellipses side by side), and one map of the error by gaze and pupil per lens. Throws RuntimeFailure
/// where gnuplot is missing.
std::vector<Figure> lens_study_figures(const LensFindings& found);

}  // namespace sturm
