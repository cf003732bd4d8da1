#pragma once
#include <string>

#include "stages/blur_field_stage.h"

namespace sturm {

/// The ellipses of all lines of sight of a blur field at the distances of its spec, as an SVG document ([Kakimoto2010]
/// fig. 12). They are drawn three times as large as they are.
std::string layers_svg(const BlurFieldSpec& spec, const TracedDirections& directions);

}  // namespace sturm
