#pragma once
#include <span>

#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"

namespace sturm {

/// Section "lens_study": conoid tracing through spectacles against real rays.
void measure_lens_study(const Json& report, Measurements& out);
std::span<const StatisticRule> lens_study_rules();

}  // namespace sturm
