#pragma once
#include <span>

#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"

namespace sturm {

/// Section "images": path-traced pictures against predicted ones.
void measure_images(const Json& report, Measurements& out);
std::span<const StatisticRule> image_rules();

}  // namespace sturm
