#include "conoid/blur_field/voxel_field.h"

#include <algorithm>

namespace sturm {

VoxelField::VoxelField(const FieldGrid& grid)
    : grid_(grid), stored_voxels_(grid.voxels()), data_(new float[stored_voxels_ * floats_per_voxel]) {}

VoxelField::VoxelField(const VoxelMask& stored) : grid_(stored.grid()), stored_(stored), stored_voxels_(0) {
  first_.reserve(grid_.directions());
  for (std::size_t d = 0; d < grid_.directions(); ++d) {
    first_.push_back(stored_voxels_);
    stored_voxels_ += stored.column_count(d);
  }
  data_.reset(new float[stored_voxels_ * floats_per_voxel]);
}

std::size_t VoxelField::memory_bytes() const {
  return stored_voxels_ * floats_per_voxel * sizeof(float) + first_.size() * sizeof(std::size_t) +
         (stored_ ? stored_->memory_bytes() : 0) + (undefined_ ? undefined_->memory_bytes() : 0);
}

void VoxelField::prepare_undefined() {
  if (!undefined_) undefined_.emplace(grid_);
}

void VoxelField::set_undefined(std::size_t direction, int k) {
  undefined_->set(direction, k);
  std::fill_n(voxel(direction, k), floats_per_voxel, 0.0f);
}

std::optional<Eigen::Matrix2f> VoxelField::angular_footprint(double ndc_x, double ndc_y, double vergence_D) const {
  const double column = grid_.column(ndc_x), row = grid_.row(ndc_y), slice = grid_.slice(vergence_D);
  const auto inside = [](double at, int n) { return at >= 0.0 && at <= n - 1; };
  if (!inside(column, grid_.nx) || !inside(row, grid_.ny) || !inside(slice, grid_.nz)) return std::nullopt;
  const auto cell = [](double at, int n) { return std::min(static_cast<int>(at), n - 2); };
  const int i = cell(column, grid_.nx), j = cell(row, grid_.ny), k = cell(slice, grid_.nz);
  const float u = static_cast<float>(column - i), v = static_cast<float>(row - j), w = static_cast<float>(slice - k);
  float sum[floats_per_voxel] = {};
  for (const int dj : {0, 1})
    for (const int di : {0, 1}) {
      const std::size_t direction = grid_.index(i + di, j + dj);
      if (!stores(direction, k) || !stores(direction, k + 1) || !defined(direction, k) || !defined(direction, k + 1))
        return std::nullopt;
      const float weight = (di ? u : 1.0f - u) * (dj ? v : 1.0f - v);
      const float* near = voxel(direction, k);
      for (int c = 0; c < floats_per_voxel; ++c)
        sum[c] += weight * ((1.0f - w) * near[c] + w * near[floats_per_voxel + c]);
    }
  return Eigen::Matrix2f{{sum[0], sum[1]}, {sum[2], sum[3]}};
}

}  // namespace sturm
