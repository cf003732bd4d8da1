#pragma once
#include "wavefront/layers/spatial_blur.h"
#include "wavefront/layers/tile_light.h"

namespace sturm {

/// Lays the next layer behind what one part of the pupil sees so far: a layer of coverage α adds min(α, 1 − A) to the
/// coverage A, and its light in the same proportion, so that pieces of one surface in two layers add up. Light without
/// coverage (that of lamps beyond the rim of their own layer) shines where there is room. Returns whether all cells are
/// covered.
bool lay_behind(const TileLight& layer, const CellBox& cells, TileLight& total);

/// Takes away what rounding leaves where nothing is: coverage below 10⁻⁶, and the light there; and light below zero.
void clear_rounding(const CellBox& cells, TileLight& layer);

}  // namespace sturm
