#pragma once
#include <span>

#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"

namespace sturm {

/// Sections "images" and "agreement": path-traced pictures against predicted ones, as metrics of whole pictures and by
/// region.
void measure_pictures(const Json& report, Measurements& out);
std::span<const StatisticRule> picture_rules();

}  // namespace sturm
