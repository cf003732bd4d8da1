#pragma once
#include <string>
#include <vector>

#include "io/json.h"

namespace sturm {

enum class Comparison {
  AtMost,    ///< passes when the statistic is ≤ bound
  AtLeast,   ///< passes when the statistic is ≥ bound
  Differs,   ///< passes when the statistic is ≥ bound: two things that must not agree
  Baseline,  ///< passes when the statistic is not lower than in the committed baseline by more than bound
  MustFail,  ///< passes when the statistic, computed from a mutated input, exceeds bound
};

/// One requirement on a named statistic of a report.
struct GateSpec {
  std::string id, title;
  std::string statistic;
  Comparison comparison = Comparison::AtMost;
  double bound = 0.0;
  std::string unit;
  std::string reason;  ///< where the bound comes from
};

/// Validates and reads a document of format sturm.gates/1; ids are unique. Throws InputError.
std::vector<GateSpec> read_gates(const Json& document, const std::string& file);

/// The word for a comparison as it stands in a gates file.
std::string to_string(Comparison comparison);

}  // namespace sturm
