#pragma once
#include <string>
#include <vector>

#include "compare/findings/ellipses.h"

namespace sturm {

/// The ellipses of a report as CSV (RFC 4180: CRLF, quoted where needed), one row per case and ray model after a header
/// that carries the units. Numbers are written so that they read back exactly; what is none is an empty field.
std::string ellipses_csv(const std::vector<EllipseFinding>& cases);

}  // namespace sturm
