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
  /// Of nothing yet. Keeps references.
  SplitWindow(const LayeredPicture& picture, const KernelBank& bank)
      : picture_(picture), bank_(bank), slopes_(bank.parts().size() > 1) {}

  /// Goes to a window, in the memory of the one before.
  void split(const TileWindow& window);

  std::span<const LayerEntry> entries_of(int plane) const {
    return {entries_.data() + first_[plane], entries_.data() + first_[plane + 1]};
  }
  std::span<const LampEntry> lamps_of(int plane) const {
    return lamps_.empty() ? std::span<const LampEntry>() : std::span<const LampEntry>(lamps_[plane]);
  }

 private:
  struct Piece {
    KernelBank::Place place;
    LayerEntry entry;  // its weight is the whole coverage
  };

  int width() const { return picture_.radiance.width; }
  int height() const { return picture_.radiance.height; }
  void find_details();
  void collect_front();
  void collect_hidden();
  void collect(int x, int y, double vergence_D, float coverage, const float* rgb, const SurfaceSlope& slope,
               const Detail* detail);
  void share_out();
  void collect_lamps();

  const LayeredPicture& picture_;
  const KernelBank& bank_;
  bool slopes_;
  TileWindow window_{};
  int left_ = 0, top_ = 0, right_ = 0, bottom_ = 0;  // of the window, within the picture
  std::vector<Piece> pieces_;
  std::vector<Detail> details_;  // of the picture's pixels, row by row, if it shows any
  std::vector<LayerEntry> entries_;
  std::vector<std::size_t> first_;             // of each plane, and one more
  std::vector<std::vector<LampEntry>> lamps_;  // of each plane, if there are any
};

}  // namespace sturm
