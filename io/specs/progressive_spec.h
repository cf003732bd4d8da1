#pragma once
#include "io/json/json.h"
#include "lensmodel/progressive.h"

namespace sturm {

/// The members of a validated "progressive" object that only progressive lenses have; `lens` holds what they share with
/// others.
ProgressiveDesign read_progressive_design(const Json& value, const Source& where, const SingleVisionDesign& lens);

}  // namespace sturm
