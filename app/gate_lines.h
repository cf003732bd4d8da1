#pragma once
#include <span>
#include <string>

#include "compare/gates/gate_result.h"

namespace sturm {

/// Results of gates as lines for people: pass or FAIL, id, value, bound.
std::string gate_lines(std::span<const GateResult> results);

}  // namespace sturm
