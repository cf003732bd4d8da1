#pragma once
#include <span>
#include <vector>

#include "compare/gates/gate_result.h"
#include "compare/gates/statistic.h"
#include "io/specs/experiment/gate_spec.h"

namespace sturm {

/// Evaluates gates on the statistics of a report: one result per gate, in the order given.
///
/// A gate fails when its statistic is unknown, has no case, or has no value. `must_fail` passes when the mutant's
/// statistic **exceeds** the bound. `baseline` compares with the same statistic of `before` (null: there is none, and
/// the gate fails): in unit "σ" how far it has fallen as a normal deviate (Welch's t: the uncertainties of a few
/// replicates are uncertain themselves), in any other unit the fall itself, which is then the value of the result. A
/// statistic "NAME/*" stands for every statistic whose name starts with "NAME/", the worst one deciding; with a
/// baseline, one that is only in either of the two reports fails the gate.
std::vector<GateResult> evaluate_gates(std::span<const GateSpec> gates, const Statistics& now,
                                       const Statistics* before);

}  // namespace sturm
