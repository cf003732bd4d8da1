#pragma once
#include <span>

#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"

namespace sturm {

/// Section "gate_power": how many gates notice each mutation.
void measure_gate_power(const Json& report, Measurements& out);
std::span<const StatisticRule> gate_power_rules();

}  // namespace sturm
