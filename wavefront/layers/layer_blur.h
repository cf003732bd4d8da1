#pragma once
#include <functional>
#include <vector>

#include "wavefront/layers/kernel_bank.h"
#include "wavefront/layers/layered_picture.h"

namespace sturm {

/// What is done with a layer within a tile.
enum class LayerWork : char {
  Empty = '.',      ///< nothing lies there
  Covered = 'c',    ///< all of it is hidden by what lies before it
  Unblurred = '=',  ///< copied
  Spatial = 's',    ///< blurred tap by tap
  Transform = 'F'   ///< blurred through the spectrum
};

/// A tile and what is done with each of its layers, by plane, nearest first.
struct TileWork {
  int left, top;
  std::vector<LayerWork> layers;
};

/// Layers of tiles, by what was done with them.
struct BlurCounters {
  int tile_side_px = 0;         ///< with the rim that is not kept
  long long lamp_pixels = 0;    ///< so bright that they were spread directly (once for each tile, plane and part)
  std::vector<TileWork> tiles;  ///< row by row

  long long layers(LayerWork work) const;
};

/// What the eye of the bank sees of the picture (docs/theory.md#143-pictures-with-depth): the light of every plane is
/// blurred and laid behind that of nearer ones, for each part of the pupil by itself; the parts are then averaged.
/// Tiles run in parallel; the same bits for any number of threads. What lies beyond the border is not known: light and
/// coverage come from within, and the light is divided by the coverage. Throws std::invalid_argument where the sizes of
/// the picture's parts do not fit together. `progress` (may be empty) is told the share of the tiles that are done,
/// from worker threads; what it throws ends the work.
Image blur_layers(const LayeredPicture& picture, const KernelBank& bank, BlurCounters& counters,
                  const std::function<void(double fraction)>& progress = {});

/// Brightness from which on a pixel is spread directly, since transforms in single precision would let its light leak
/// over its whole tile: 1000 times the median, and that of at most one pixel in twenty.
float lamp_level(const Image& radiance);

}  // namespace sturm
