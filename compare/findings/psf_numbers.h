#pragma once
#include <span>

#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"

namespace sturm {

/// The numbers of the section "psfs" (compare/findings/psfs.h), and what gates make of them.
void measure_psfs(const Json& report, Measurements& out);
std::span<const StatisticRule> psf_rules();

}  // namespace sturm
