#pragma once
#include <optional>
#include <string>

#include "io/json/json.h"

namespace sturm {

/// JUnit XML (as CI servers read it) of the array "gates" of a report: one test case per gate, its class name the suite
/// and the kind of gate. `seconds` is the time of the whole run. UTF-8; control characters, which XML 1.0 cannot hold,
/// become U+FFFD.
std::string junit_xml(const Json& gate_results, const std::string& suite, std::optional<double> seconds = std::nullopt);

}  // namespace sturm
