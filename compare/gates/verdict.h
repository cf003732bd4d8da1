#pragma once
#include <map>
#include <optional>
#include <span>
#include <string>

#include "compare/gates/gate_result.h"
#include "io/json/json.h"

namespace sturm {

/// The outcome of a run.
struct Verdict {
  std::optional<bool> passed;  ///< all gates; none where there are no gates
  std::string sentence;        ///< "22 of 22 gates passed.", or the names of those that failed
  /// What sections measured, each in a sentence, by its key in the report ("sin2_sentence"); none where a section has
  /// nothing to say.
  std::map<std::string, std::optional<std::string>> findings;

  bool has_passed() const { return passed.value_or(false); }
  bool has_failed() const { return !passed.value_or(true); }
  std::string finding(const std::string& key) const;  ///< or ""
};

/// Of gates alone. No gates at all is neither a pass nor a failure.
Verdict verdict_of(std::span<const GateResult> results);

/// The section "verdict".
Json to_json(const Verdict& verdict);

/// Of a report ("sturm.report/1").
Verdict read_verdict(const Json& report);

}  // namespace sturm
