#pragma once
#include "pathtrace/film/pixel_source.h"

namespace sturm {

/// Samples of one pixel in one pass. A multiple of CameraRayBlock::size, so that the camera's rays form the same
/// packets as in one go.
inline constexpr std::uint32_t samples_per_pass = 16;

/// Stream 0 of every pixel in passes of samples_per_pass, until samples_per_pixel or until settings.after_pass ends it.
/// The pixels keep their statistics between passes and add samples in the same order, so that N samples in passes are
/// the same bits as N in one go.
RenderResult render_in_passes(const PixelSource& source, const RenderSettings& settings);

}  // namespace sturm
