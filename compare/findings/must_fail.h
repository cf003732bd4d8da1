#pragma once
#include <span>

#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"

namespace sturm {

/// Section "must_fail": deliberate errors, each of which a check must notice.
void measure_must_fail(const Json& report, Measurements& out);
std::span<const StatisticRule> must_fail_rules();

}  // namespace sturm
