#pragma once
#include "compare/findings/measurement.h"
#include "io/json/json.h"

namespace sturm {

/// The noise floors of an entry of the report that has `noise_floor`, as numbers between runs; `name` ends with ": ".
/// Standard errors where it has `noise_floor_uncertainty`, whose two halves of `replicates` pictures have one degree of
/// freedom less each. `about` gives section, subject and model.
void add_noise_floor(const Json& entry, const std::string& name, const Number& replicates, const Measurement& about,
                     Measurements& out);

}  // namespace sturm
