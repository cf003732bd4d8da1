#pragma once
#include <span>
#include <string>

#include "compare/gates/gate_result.h"
#include "compare/gates/verdict.h"
#include "io/json/json.h"

namespace sturm {

/// What gates said, for a pull request, in Markdown with tables (GitHub's and GitLab's): title and verdict, gates with
/// failures first and the passed ones folded. Texts cannot break out of their cell.
std::string gates_markdown(const std::string& title, std::span<const GateResult> results, const Verdict& verdict);

/// A short summary for a pull request of a run: its gates and its conditions.
std::string report_markdown(const Json& report, std::span<const GateResult> results, const Verdict& verdict);

}  // namespace sturm
