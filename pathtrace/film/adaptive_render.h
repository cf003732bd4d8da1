#pragma once
#include "pathtrace/film/pixel_source.h"

namespace sturm {

/// Renders until the relative MSE is settings.relative_error², per tile (settings.adaptive) or for the whole picture.
///
/// Four independently scrambled streams, two to a half. Half A's streams tell how far *half B* goes, and B's tell how
/// far A goes; the picture is (A + B)/2. How many samples A keeps is thus a function of B's samples alone, which are
/// independent of A's: given that number, A is what a rendering with so many samples would be, and its mean is right.
/// The plain rule, to stop where a pixel's own samples look quiet, keeps the pixels that have missed a rare event (Kirk
/// & Arvo 1991, "Unbiased sampling techniques"). Where one half must go further than the other, so that its samples can
/// decide, those samples steer and are not kept.
///
/// The error of a half is measured between its two streams, so that it is right for low-discrepancy samples as well,
/// over the pixels of a tile. Passes double the samples; decisions are made after each, in the order of the tiles.
RenderResult render_to_error(const PixelSource& source, const RenderSettings& settings);

}  // namespace sturm
