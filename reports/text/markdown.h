#pragma once
#include <string>

#include "io/json/json.h"

namespace sturm {

/// A short summary for a pull request in Markdown with tables (GitHub's and GitLab's): verdict, gates with failures
/// first and the passed ones folded, conditions. `gate_results` and `verdict` as in compare/gates/gates.h; texts of the
/// report cannot break out of their cell.
std::string report_markdown(const Json& report, const Json& gate_results, const Json& verdict);

}  // namespace sturm
