#pragma once
#include "io/json/json.h"
#include "reports/markup/html.h"

namespace sturm {

/// "Made by: sturm run EXPERIMENT --seed N", from the report's provenance; nothing where the report names no
/// experiment.
Html made_by(const Json& report);

}  // namespace sturm
