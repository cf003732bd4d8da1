#pragma once
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "conoid/blur_field/field_grid.h"
#include "conoid/blur_field/voxel_mask.h"

namespace sturm {

/// Blur field as published: one 2×2 matrix X/d [rad/m] on (e1, e2) in single precision for each voxel of a grid, read
/// by trilinear interpolation. All voxels, or only those of a mask. [Kakimoto2010] §4
class VoxelField {
 public:
  static constexpr int floats_per_voxel = 4;  ///< xx, xy, yx, yy

  /// Room for all voxels, or for those of the mask; not filled yet.
  explicit VoxelField(const FieldGrid& grid);
  explicit VoxelField(const VoxelMask& stored);  ///< of the mask's grid

  const FieldGrid& grid() const { return grid_; }      ///< all of it, stored or not
  bool sparse() const { return stored_.has_value(); }  ///< made for a mask
  bool stores(std::size_t direction, int k) const {
    return !stored_ || stored_->has(direction, k);
  }                                                             ///< k = 0 is the nearest
  std::size_t stored_voxels() const { return stored_voxels_; }  ///< of all directions
  std::size_t memory_bytes() const;                             ///< of the numbers, the mask and the notes

  /// The voxels of one direction that are stored, in the order of depth.
  float* column(std::size_t direction) { return data_.get() + first_voxel(direction) * floats_per_voxel; }
  const float* column(std::size_t direction) const { return data_.get() + first_voxel(direction) * floats_per_voxel; }

  /// One stored voxel.
  const float* voxel(std::size_t direction, int k) const {
    return column(direction) + place(direction, k) * floats_per_voxel;
  }
  float* voxel(std::size_t direction, int k) {
    return column(direction) + place(direction, k) * floats_per_voxel;
  }  ///< the same

  /// Notes that a voxel has no footprint: a lost chief ray, a failure of eq. 11, a focus on a surface. Its numbers are
  /// 0.
  void set_undefined(std::size_t direction, int k);
  bool defined(std::size_t direction, int k) const {
    return !undefined_ || !undefined_->has(direction, k);
  }                                                                                       ///< it has a footprint
  std::uint64_t undefined_count() const { return undefined_ ? undefined_->count() : 0; }  ///< voxels without one
  void prepare_undefined();  ///< makes room for such notes; afterwards threads may note voxels of different directions
                             ///< at the same time

  /// X/d [rad/m], trilinear. None outside of the grid and where one of the 8 voxels around is not stored or undefined.
  std::optional<Eigen::Matrix2f> angular_footprint(double ndc_x, double ndc_y, double vergence_D) const;

 private:
  std::size_t first_voxel(std::size_t direction) const {
    return stored_ ? first_[direction] : direction * static_cast<std::size_t>(grid_.nz);
  }
  std::size_t place(std::size_t direction, int k) const {
    return stored_ ? stored_->rank(direction, k) : static_cast<std::size_t>(k);
  }

  FieldGrid grid_;
  std::optional<VoxelMask> stored_, undefined_;
  std::vector<std::size_t> first_;  ///< of each direction, where only some voxels are stored
  std::size_t stored_voxels_;
  std::unique_ptr<float[]> data_;
};

}  // namespace sturm
