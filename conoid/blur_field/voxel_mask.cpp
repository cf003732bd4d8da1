#include "conoid/blur_field/voxel_mask.h"

#include <algorithm>
#include <cmath>

namespace sturm {

void VoxelMask::add_look_up(double ndc_x, double ndc_y, double vergence_D) {
  const double column = grid_.column(ndc_x), row = grid_.row(ndc_y), slice = grid_.slice(vergence_D);
  const auto inside = [](double at, int n) { return at >= 0.0 && at <= n - 1; };
  if (!inside(column, grid_.nx) || !inside(row, grid_.ny) || !inside(slice, grid_.nz)) return;
  const auto cell = [](double at, int n) { return std::min(static_cast<int>(at), n - 2); };
  const int i = cell(column, grid_.nx), j = cell(row, grid_.ny), k = cell(slice, grid_.nz);
  for (const int dj : {0, 1})
    for (const int di : {0, 1})
      for (const int dk : {0, 1}) set(grid_.index(i + di, j + dj), k + dk);
}

std::uint64_t VoxelMask::count() const {
  std::uint64_t all = 0;
  for (const std::uint64_t w : words_) all += static_cast<std::uint64_t>(std::popcount(w));
  return all;
}

}  // namespace sturm
