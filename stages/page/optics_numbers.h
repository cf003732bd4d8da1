#pragma once
#include "io/json/json.h"
#include "io/specs/lens_design.h"
#include "lensmodel/eye.h"
#include "lensmodel/spectacles.h"

namespace sturm {

// Eyes and lenses as plain numbers, from which the core of a viewer's page builds the same ones again
// (viewer/src/core_module.d.ts: EyeNumbers, LensNumbers). Metres, dioptres, radians.

Json eye_numbers(const Eye& eye);

/// Two surfaces and how they stand, however the lens was made.
Json lens_numbers(const Spectacles& lens);

/// What a lens is made from.
Json lens_numbers(const LensDesign& design);

}  // namespace sturm
