#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compare/gates/extreme_statistic.h"
#include "io/json/json.h"
#include "io/specs/experiment/gate_spec.h"

namespace sturm {

/// What a gate said of a report.
struct GateResult {
  std::string id, title;
  std::optional<GateKind> kind;
  std::optional<bool> passed;
  std::string statistic;
  Number value, uncertainty;  ///< of the statistic; of a baseline gate how far it has fallen. In the gate's unit
  Number bound;
  std::string unit;
  std::optional<std::uint64_t> cases;  ///< behind the value
  std::string worst_case;              ///< the one that decided
  std::string reason;                  ///< where the bound comes from
  std::optional<GateCalibration> calibration;

  /// What does not say that it has passed has failed.
  bool has_passed() const { return passed.value_or(false); }
};

/// The list "gates" of a report.
Json to_json(const std::vector<GateResult>& results);

/// Of a report ("sturm.report/1"); whatever is missing, null or of another type is none.
std::vector<GateResult> read_gate_results(const Json& report);

/// The gate that gave a result; none where it does not state its kind or its bound.
std::optional<GateSpec> gate_of(const GateResult& result);

}  // namespace sturm
