#pragma once
#include <span>

#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"

namespace sturm {

/// Section "sin2_study": sin² interpolation against wavefront theory.
void measure_sin2_study(const Json& report, Measurements& out);
std::span<const StatisticRule> sin2_study_rules();

}  // namespace sturm
