#pragma once
#include <span>

#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"

namespace sturm {

/// Section "agreement": predictions of several kinds against path tracing, by parts of the picture.
void measure_agreement(const Json& report, Measurements& out);
std::span<const StatisticRule> agreement_rules();

}  // namespace sturm
