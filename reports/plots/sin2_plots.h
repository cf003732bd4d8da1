#pragma once
#include <vector>

#include "compare/findings/ellipses.h"
#include "compare/findings/sin2.h"
#include "reports/markup/html.h"

namespace sturm {

/// Measured ÷ true semi-axes of sin² rays against t = V₂/V₁, |V₁| ≥ |V₂|, over the closed forms of
/// docs/theory.md#61-second-moments-in-closed-form: two <svg> plots, major and minor axis; nothing where there is no
/// such case.
Html sin2_ratio_plots(const std::vector<Sin2Case>& cases);

/// Relative difference of the covariances of rays and conoid (Frobenius norm) against the size of the cylinder, one
/// <svg>; nothing likewise.
Html difference_plot(const std::vector<EllipseFinding>& cases);

}  // namespace sturm
