#pragma once
#include <span>

#include "wavefront/layers/layered_picture.h"

namespace sturm {

/// Parts what an antialiased picture has mixed at its edges, where layers tell the colour B behind: a mixed pixel holds
/// α N + (1 − α) B, and its unmixed neighbours tell N, which gives the coverage α. The near surface's share becomes a
/// piece of its own, so that each surface blurs with its own distance. `picture.hidden` must be that of the layers.
void unmix_edges(LayeredPicture& picture, std::span<const PictureLayer> layers);

}  // namespace sturm
