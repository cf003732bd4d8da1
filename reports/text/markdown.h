#pragma once
#include <span>
#include <string>

#include "compare/gates/gate_result.h"
#include "compare/gates/verdict.h"
#include "io/json/json.h"

namespace sturm {

/// A short summary for a pull request in Markdown with tables (GitHub's and GitLab's): verdict, gates with failures
/// first and the passed ones folded, conditions. Texts of the report cannot break out of their cell.
std::string report_markdown(const Json& report, std::span<const GateResult> results, const Verdict& verdict);

}  // namespace sturm
