#pragma once
#include "compare/findings/measurement.h"
#include "compare/findings/sections.h"
#include "io/json/json.h"

namespace sturm {

/// The rows of the report's table of cases, in reading order: failures first, then by |z|. A case is `Failed` when it
/// is the one that decided a failed gate.
Measurements case_rows(const Json& report, std::span<const FindingSection> sections = finding_sections());

}  // namespace sturm
