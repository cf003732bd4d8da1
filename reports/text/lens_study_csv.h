#pragma once
#include <string>

#include "compare/studies/lens/lens_findings.h"
#include "io/json/json.h"

namespace sturm {

/// The section "lens_study" as CSV (RFC 4180: CRLF, quoted where needed), one row per view, pupil and method after a
/// header that carries the units; a line of sight that gives no view has one row with its status. Numbers are written
/// so that they read back exactly; a null is an empty field.
std::string lens_study_csv(const LensFindings& found);

}  // namespace sturm
