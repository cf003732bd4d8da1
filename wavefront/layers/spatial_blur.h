#pragma once
#include "io/images/image.h"
#include "wavefront/psf/spread_kernel.h"

namespace sturm {

/// A rectangle of cells of a tile: columns [left, right), rows [top, bottom).
struct CellBox {
  int left = 0, top = 0, right = 0, bottom = 0;

  bool empty() const { return left >= right || top >= bottom; }
  long long area() const { return empty() ? 0 : static_cast<long long>(right - left) * (bottom - top); }
  CellBox grown(int by) const { return {left - by, top - by, right + by, bottom + by}; }
  CellBox within(const CellBox& other) const;
};

/// Adds to the cells of `into` what the kernel makes of the light in `from`; beyond `from` the tile is dark.
void add_blurred(const Image& light, const CellBox& from, const SpreadKernel& kernel, const CellBox& into,
                 Image& blurred);

}  // namespace sturm
