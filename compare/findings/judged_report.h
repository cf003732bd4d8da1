#pragma once
#include <span>
#include <vector>

#include "compare/findings/sections.h"
#include "compare/gates/gate_result.h"
#include "io/json/json.h"
#include "io/specs/experiment/gate_spec.h"

namespace sturm {

/// Evaluates gates on a stored report, against the stored report `baseline` (null: there is none). See
/// compare/gates/gates.h.
std::vector<GateResult> evaluate_gates(std::span<const GateSpec> gates, const Json& report, const Json* baseline,
                                       std::span<const FindingSection> sections = finding_sections());

}  // namespace sturm
