#pragma once
#include <span>

#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"

namespace sturm {

/// Section "psfs": rendered spots against the conoid's ellipses.
void measure_psfs(const Json& report, Measurements& out);
std::span<const StatisticRule> psf_rules();

}  // namespace sturm
