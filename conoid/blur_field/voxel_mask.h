#pragma once
#include <bit>
#include <cstdint>
#include <vector>

#include "conoid/blur_field/field_grid.h"

namespace sturm {

/// A set of voxels of a grid, one bit each, ordered by direction and then by depth.
class VoxelMask {
 public:
  explicit VoxelMask(const FieldGrid& grid)
      : grid_(grid),
        words_per_column_((static_cast<std::size_t>(grid.nz) + 63) / 64),
        words_(grid.directions() * words_per_column_, 0) {}

  const FieldGrid& grid() const { return grid_; }
  void set(std::size_t direction, int k) { word(direction, k) |= bit(k); }
  bool has(std::size_t direction, int k) const { return (word(direction, k) & bit(k)) != 0; }

  /// Adds the 8 voxels that a look-up at this place reads; nothing outside of the grid.
  void add_look_up(double ndc_x, double ndc_y, double vergence_D);

  std::uint64_t count() const;

  /// How many voxels of a direction's column are in the set before slice k.
  std::uint32_t rank(std::size_t direction, int k) const {
    const std::uint64_t* column = &words_[direction * words_per_column_];
    std::uint32_t before = 0;
    for (int w = 0; w < k / 64; ++w) before += static_cast<std::uint32_t>(std::popcount(column[w]));
    return before + static_cast<std::uint32_t>(std::popcount(column[k / 64] & (bit(k) - 1)));
  }
  std::uint32_t column_count(std::size_t direction) const {
    std::uint32_t all = 0;
    for (std::size_t w = 0; w < words_per_column_; ++w)
      all += static_cast<std::uint32_t>(std::popcount(words_[direction * words_per_column_ + w]));
    return all;
  }
  std::size_t memory_bytes() const { return words_.size() * sizeof(std::uint64_t); }

 private:
  static std::uint64_t bit(int k) { return std::uint64_t{1} << (k % 64); }
  std::uint64_t& word(std::size_t direction, int k) {
    return words_[direction * words_per_column_ + static_cast<std::size_t>(k / 64)];
  }
  const std::uint64_t& word(std::size_t direction, int k) const {
    return words_[direction * words_per_column_ + static_cast<std::size_t>(k / 64)];
  }

  FieldGrid grid_;
  std::size_t words_per_column_;
  std::vector<std::uint64_t> words_;
};

}  // namespace sturm
