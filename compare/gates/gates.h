#pragma once
#include <span>

#include "compare/gates/statistic.h"
#include "io/json/json.h"
#include "io/specs/experiment/gate_spec.h"

namespace sturm {

/// Evaluates gates on the statistics of a report; the result is the array "gates" of report.json, one entry per gate in
/// the order given.
///
/// A gate fails when its statistic is unknown, has no case, or has no value. `must_fail` passes when the mutant's
/// statistic **exceeds** the bound. `baseline` compares with the same statistic of `before` (null: there is none, and
/// the gate fails): in unit "σ" how far it has fallen as a normal deviate (Welch's t: the uncertainties of a few
/// replicates are uncertain themselves), in any other unit the fall itself, which is then the value of the entry. A
/// statistic "NAME/*" stands for every statistic whose name starts with "NAME/", the worst one deciding; with a
/// baseline, one that is only in either of the two reports fails the gate.
Json evaluate_gates(std::span<const GateSpec> gates, const Statistics& now, const Statistics* before);

/// {"passed": true, "sentence": "22 of 22 gates passed."}, or the names of those that failed. No gates at all is not a
/// pass.
Json verdict_of(const Json& gate_results);

}  // namespace sturm
