#pragma once
#include <string_view>

#include "io/specs/lens_files/lens_file.h"

namespace sturm {

/// The lens in the text of a sequential .zmx file: the two surfaces about its one glass. Surfaces: STANDARD, EVENASPH
/// without higher terms, TOROIDAL without polynomials, GRID_SAG. docs/formats/lens_files.md. Throws InputError.
LensFile zemax_lens(std::string_view text, const LensFileRequest& request);

}  // namespace sturm
