#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"

namespace sturm {

/// A deliberate error that a check must notice.
struct MutantFinding {
  std::string id, what;
  std::optional<bool> failed_as_it_must;  ///< whether the check noticed
  Number value, bound;                    ///< of the check: beyond the bound it has noticed
};

/// Section "must_fail".
Json to_json(const std::vector<MutantFinding>& mutants);

/// Of a report ("sturm.report/1").
std::vector<MutantFinding> read_must_fail(const Json& report);

void measure_must_fail(const Json& report, Measurements& out);
std::span<const StatisticRule> must_fail_rules();

}  // namespace sturm
