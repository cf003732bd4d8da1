#pragma once
#include <span>

#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"

namespace sturm {

/// Section "design_study": lens designs and what a population sees through them.
void measure_design_study(const Json& report, Measurements& out);
std::span<const StatisticRule> design_study_rules();

}  // namespace sturm
