#pragma once
#include <vector>

#include "io/images/exr_parts.h"
#include "stages/psf_stage.h"

namespace sturm {

/// Each point spread as a part of an EXR file with one channel Y: the share of the energy in each pixel; row 0 is the
/// top.
std::vector<ExrPart> psf_parts(const PsfSpec& spec, const PointSpreads& spreads);

/// All of them in one picture of linear light: a row for each light and model, a column for each target; each is bright
/// where it has its own maximum.
Image psf_sheet(const PsfSpec& spec, const PointSpreads& spreads);

}  // namespace sturm
