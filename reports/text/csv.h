#pragma once
#include <string>

#include "compare/studies/lens/lens_findings.h"
#include "io/json/json.h"

namespace sturm {

/// The ellipses of a report as CSV (RFC 4180: CRLF, quoted where needed), one row per case and ray model after a header
/// that carries the units. Numbers are written so that they read back exactly; a null is an empty field.
std::string ellipses_csv(const Json& report);

/// The section "lens_study" in the same way, one row per view, pupil and method; a line of sight that gives no view has
/// one row with its status.
std::string lens_study_csv(const LensFindings& found);

}  // namespace sturm
