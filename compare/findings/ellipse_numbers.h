#pragma once
#include <span>

#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"

namespace sturm {

/// The numbers of the section "ellipses" (compare/findings/ellipses.h), and what gates make of them.
void measure_ellipses(const Json& report, Measurements& out);
std::span<const StatisticRule> ellipse_rules();

}  // namespace sturm
