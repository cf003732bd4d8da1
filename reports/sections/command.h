#pragma once
#include <string>

#include "io/json/json.h"

namespace sturm {

/// "Made by: sturm run EXPERIMENT --seed N" as HTML, from the report's provenance; "" where the report names no
/// experiment.
std::string made_by(const Json& report);

}  // namespace sturm
