#pragma once
#include <span>

#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"

namespace sturm {

/// Section "sampling_study": ways to spread rays over the pupil.
void measure_sampling_study(const Json& report, Measurements& out);
std::span<const StatisticRule> sampling_study_rules();

}  // namespace sturm
