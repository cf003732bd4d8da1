#pragma once
#include <span>

#include "wavefront/layers/layered_picture.h"

namespace sturm {

/// Parts what an antialiased picture has mixed at its edges: a mixed pixel holds α N + (1 − α) B, and its unmixed
/// neighbours tell N, which gives the coverage α. Layers tell the colour B behind; without any, the unmixed pixels
/// beside the edge do, and where these vary the pixel stays as the depth map has it. Where the colours of the near
/// neighbours vary, or no α explains the pixel, α is rather that of a straight edge between the pixels about it. The
/// near surface's share becomes a piece of its own, so that each surface blurs with its own distance. Where a layer of
/// the near surface itself is among them, it tells both α and N. `picture.hidden` must be that of the layers.
void unmix_edges(LayeredPicture& picture, std::span<const PictureLayer> layers);

/// The same where the picture's edges are known already: `edges` is `edges_of` it.
void unmix_edges(LayeredPicture& picture, std::span<const PictureLayer> layers, std::span<const std::size_t> edges);

}  // namespace sturm
