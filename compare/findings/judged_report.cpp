#include "compare/findings/judged_report.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "compare/findings/gate_statistics.h"
#include "compare/gates/gates.h"

namespace sturm {

std::vector<GateResult> evaluate_gates(std::span<const GateSpec> gates, const Json& report, const Json* baseline,
                                       std::span<const FindingSection> sections) {
  std::optional<Statistics> before;
  if (baseline && !baseline->is_null()) before = statistics_of(*baseline, sections);
  return evaluate_gates(gates, statistics_of(report, sections), before ? &*before : nullptr);
}

}  // namespace sturm
