#pragma once
#include "compare/findings/measurement.h"
#include "io/json/json.h"

namespace sturm {

/// Section "reference": the conoid and the closed form of sin² against independently computed numbers.
void measure_reference(const Json& report, Measurements& out);

}  // namespace sturm
