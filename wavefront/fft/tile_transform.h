#pragma once
#include "io/images/image.h"

namespace sturm {

// The discrete Fourier transform of real square tiles: one channel of side × side values, the side a power of two. A
// spectrum is packed as OpenCV packs those of real pictures (CCS), so that it needs as much memory as its tile. All
// images have their size before; the same bits for any number of threads.

/// The spectrum of a tile.
void transform_tile(const Image& tile, Image& spectrum);

/// The tile of a spectrum; the two transforms undo each other.
void tile_of_spectrum(const Image& spectrum, Image& tile);

/// The spectrum of the circular convolution of two tiles.
void product_of_spectra(const Image& a, const Image& b, Image& product);

}  // namespace sturm
