#pragma once
#include <optional>

#include "compare/studies/lens/lens_findings.h"
#include "reports/plots/figure.h"

namespace sturm {

/// The wide field of [Kakimoto2010] Fig. 14, from the report's "lens_study/field": semi-axes of the blur against the
/// gaze for real rays and every method. None without an ellipse.
std::optional<Figure> field_curves(const LensField& field);

/// The same ellipses drawn side by side: one row per method, real rays on top and again as an outline behind each.
std::optional<Figure> field_ellipses(const LensField& field);

}  // namespace sturm
