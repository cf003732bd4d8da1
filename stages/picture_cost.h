#pragma once
#include <string>

#include "stages/render_stage.h"

namespace sturm {

/// What a picture took and what that bought, in one sentence for its user: the seconds of its parts, and the error to
/// expect. Of a path-traced picture this is its noise, as independent samples would have it: the root of the mean
/// variance of pixels over the root of their mean square. Of a prediction it is the number of path-traced samples with
/// the same SSIM in the shipped views.
std::string cost_of(const RenderSpec& spec, const RenderOutput& picture);

}  // namespace sturm
