#pragma once
#include <span>
#include <string>

#include "compare/findings/sections.h"
#include "io/json/json.h"
#include "io/specs/experiment/gate_spec.h"

namespace sturm {

struct MutationName {
  std::string id, what;
};

/// A report whose entries of "ellipses/cases", "psfs" and "images" may hold patches (RFC 7396) under "mutated", by the
/// mutation's id: the same entries with one predictor made wrong. This is the report that the mutated predictor would
/// have brought about.
Json mutated_report(const Json& report, const std::string& mutation);

/// Takes the patches away: what is stored is the honest report.
void drop_mutated(Json& report);

/// Which gates notice which mutation: those that pass on the honest report and fail on the mutated one. The section
/// "gate_power" of the report, with the expected number of false alarms in a run (the sum of the gates' levels; null
/// where a gate states none). `baseline`: null if there is none.
Json gate_power(std::span<const GateSpec> gates, const Json& report, std::span<const MutationName> mutations,
                const Json& baseline, std::span<const FindingSection> sections = finding_sections());

}  // namespace sturm
