#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "wavefront/layers/kernel_bank.h"
#include "wavefront/layers/layered_picture.h"
#include "wavefront/layers/spatial_blur.h"

namespace sturm {

/// A square of pixels of a picture; it may stick out of it.
struct TileWindow {
  int left, top, side;
};

/// What one pixel of a surface gives to one plane.
struct LayerEntry {
  std::uint32_t cell;      ///< of the window, row by row
  float weight;            ///< coverage that it gives to the plane
  const float* rgb;        ///< its colour
  float slope_x, slope_y;  ///< of its surface [D/px], to the right and down; 0 where the pupil is in one part
  const Detail* detail;    ///< null: none
};

/// What a lamp gives to one plane.
struct LampEntry {
  std::uint32_t cell;  ///< of the window
  float weight;        ///< share of its light
  const LampPixel* lamp;
};

/// The least box about entries of a window.
CellBox box_of(std::span<const LayerEntry> entries, int side);

/// What a window of a picture gives to every plane: each pixel is shared out between the two planes about its vergence
/// by linear weights, so that slanted surfaces have no steps.
class SplitWindow {
 public:
  SplitWindow(const LayeredPicture& picture, const KernelBank& bank, const TileWindow& window);

  std::span<const LayerEntry> entries_of(int plane) const {
    return {entries_.data() + first_[plane], entries_.data() + first_[plane + 1]};
  }
  std::span<const LampEntry> lamps_of(int plane) const {
    return lamps_.empty() ? std::span<const LampEntry>() : std::span<const LampEntry>(lamps_[plane]);
  }

 private:
  void add_lamps(const LayeredPicture& picture, const KernelBank& bank, const TileWindow& window);

  std::vector<std::vector<LampEntry>> lamps_;  // of each plane, if there are any
  std::vector<LayerEntry> entries_;
  std::vector<std::size_t> first_;  // of each plane, and one more
};

}  // namespace sturm
