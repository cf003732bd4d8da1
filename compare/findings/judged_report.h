#pragma once
#include <span>

#include "io/gate_spec.h"
#include "io/json.h"

namespace sturm {

/// Evaluates gates on a stored report, against the stored report `baseline` (null: there is none). See compare/gates/gates.h.
Json evaluate_gates(std::span<const GateSpec> gates, const Json& report, const Json* baseline);

}  // namespace sturm
