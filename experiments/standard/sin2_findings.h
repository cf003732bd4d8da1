#pragma once
#include <optional>
#include <span>
#include <string>

#include "compare/findings/sin2.h"
#include "experiments/standard/traced_cases.h"

namespace sturm {

/// What sin² interpolation does in the cases with a cylinder.
Sin2Findings sin2_findings(std::span<const TracedCase> cases);

/// The measured facts about sin² in one sentence; none without a case that they can be told in.
std::optional<std::string> sin2_sentence(const Sin2Findings& sin2);

}  // namespace sturm
