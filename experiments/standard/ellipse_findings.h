#pragma once
#include <span>

#include "compare/findings/ellipses.h"
#include "experiments/run/mutations.h"
#include "experiments/standard/traced_cases.h"

namespace sturm {

/// Blur ellipses of every case by the conoid and by every ray model, and what mutated predictors would have found.
EllipseFindings ellipse_findings(const EllipseExperiment& spec, std::span<const TracedCase> cases,
                                 std::span<const Mutation> mutations);

}  // namespace sturm
