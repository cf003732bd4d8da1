#pragma once
#include <span>

#include "wavefront/layers/layered_picture.h"

namespace sturm {

/// Parts what an antialiased picture has mixed at its edges, where layers tell the colour B behind: a mixed pixel holds
/// α N + (1 − α) B, and its unmixed neighbours tell N, which gives the coverage α. Where the colours of those
/// neighbours vary, or no α explains the pixel, α is rather that of a straight edge between the pixels about it. The
/// near surface's share becomes a piece of its own, so that each surface blurs with its own distance. Where a layer of
/// the near surface itself is among them, it tells both α and N. `picture.hidden` must be that of the layers.
void unmix_edges(LayeredPicture& picture, std::span<const PictureLayer> layers);

}  // namespace sturm
