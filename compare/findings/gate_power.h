#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compare/findings/statistic_rule.h"
#include "io/json/json.h"
#include "io/specs/experiment/gate_spec.h"

namespace sturm {

/// A gate that noticed a mutation: its value under the mutation and without it, in its unit.
struct GateThatNoticed {
  std::string gate;
  Number value, honest_value, bound;
  std::string unit;
};

/// An error that was put into one predictor, and the gates that pass on the honest report and fail with it.
struct NoticedMutation {
  std::string id, what;
  std::vector<GateThatNoticed> caught_by;
};

/// Section "gate_power": what the gates can see.
struct GatePower {
  std::vector<NoticedMutation> mutations;
  std::optional<std::uint64_t> gates;  ///< how many there are
  /// Expected number in a run, the sum of the gates' levels; none where a gate states none: the sum would be too small.
  Number false_alarms_per_run;
};

/// What a report says in numbers where one predictor has this error.
struct MutatedStatistics {
  std::string id, what;
  Statistics statistics;
};

/// Which gates notice which mutation. `before`: of the baseline, null if there is none.
GatePower gate_power(std::span<const GateSpec> gates, const Statistics& honest,
                     std::span<const MutatedStatistics> mutated, const Statistics* before);

Json to_json(const GatePower& power);

/// Of a report ("sturm.report/1").
GatePower read_gate_power(const Json& report);

void measure_gate_power(const Json& report, Measurements& out);
std::span<const StatisticRule> gate_power_rules();

}  // namespace sturm
