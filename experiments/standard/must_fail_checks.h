#pragma once
#include <span>
#include <vector>

#include "compare/findings/must_fail.h"
#include "experiments/standard/traced_cases.h"

namespace sturm {

/// The comparison of rays with the conoid again, with a conoid that is wrong on purpose: mirrored axis, vertex distance
/// dropped, and sin² rays passed off as matrix rays. Each must be noticed.
std::vector<MutantFinding> must_fail_checks(std::span<const TracedCase> cases);

}  // namespace sturm
