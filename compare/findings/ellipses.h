#pragma once
#include <span>

#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"

namespace sturm {

/// Section "ellipses": blur ellipses of rays against the conoid and against the closed form of sin².
void measure_ellipses(const Json& report, Measurements& out);
std::span<const StatisticRule> ellipse_rules();

}  // namespace sturm
