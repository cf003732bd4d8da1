#pragma once
#include <optional>
#include <span>
#include <string>

#include "compare/gates/gate_result.h"

namespace sturm {

/// JUnit XML (as CI servers read it) of the gates of a report: one test case per gate, its class name the suite
/// and the kind of gate. `seconds` is the time of the whole run. UTF-8; control characters, which XML 1.0 cannot hold,
/// become U+FFFD.
std::string junit_xml(std::span<const GateResult> results, const std::string& suite,
                      std::optional<double> seconds = std::nullopt);

}  // namespace sturm
