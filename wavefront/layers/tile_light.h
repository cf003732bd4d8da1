#pragma once
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// Light and coverage of a tile, in planes of side × side values each: colours R, G, B, then the coverage, or one for
/// each colour where colours blur differently. Colours are multiplied by the coverage.
struct TileLight {
  std::vector<Image> planes;

  TileLight(int side, int coverages) : planes(3 + static_cast<std::size_t>(coverages), Image(side, side, 1)) {}

  int count() const { return static_cast<int>(planes.size()); }
  int side() const { return planes[0].width; }
  int coverages() const { return count() - 3; }

  /// Which of `coverages` kernels blurs a plane.
  int kernel_of(int plane) const { return coverages() == 1 ? 0 : plane % 3; }
  void clear();
};

}  // namespace sturm
