#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "conoid/blur_field/field_grid.h"
#include "conoid/blur_field/traced_directions.h"
#include "lensmodel/power_matrix.h"

namespace sturm {

/// Blur field without samples in depth: for each direction the map X/d = V A + B − a (V Q₀ + Q₁) in single precision,
/// which is exact for every vergence V = 1/d and every accommodation a of one eye (docs/theory.md#118-blur-fields).
/// Only the direction is interpolated (bilinear).
class DepthAnalyticField {
 public:
  /// X/d [rad/m] row by row, and what accommodation takes off, of one direction: one cache line.
  struct alignas(64) Node {
    float a[4], b[4], q0[4], q1[4];  ///< X/d = V a + b − A (V q0 + q1) at the vergence V and the accommodation A [D]
  };

  /// `correction` is the eye's F [D].
  DepthAnalyticField(const FieldGrid& grid, const TracedDirections& directions, const PowerMatrix& correction);

  /// As they were stored. `usable` holds 1 for each direction that has a conoid. Throws std::invalid_argument where the
  /// sizes do not fit.
  DepthAnalyticField(const FieldGrid& grid, std::vector<Node> nodes, std::vector<std::uint8_t> usable);

  const FieldGrid& grid() const { return grid_; }                      ///< where the directions are
  const std::vector<Node>& nodes() const { return nodes_; }            ///< in the order of FieldGrid::index
  const std::vector<std::uint8_t>& usable() const { return usable_; }  ///< 1 where a node has a conoid
  /// Of nodes and of what tells where they are usable.
  std::size_t memory_bytes() const { return nodes_.size() * sizeof(Node) + usable_.size() + cells_.size(); }

  /// X/d [rad/m] on (e1, e2) in normalised coordinates, for any vergence and accommodation [D]. None outside of the
  /// field of view and where one of the four directions around has no conoid.
  std::optional<Eigen::Matrix2f> angular_footprint(float ndc_x, float ndc_y, float vergence_D,
                                                   float accommodation_D) const {
    const float column = half_columns_ * (ndc_x + 1.0f), row = half_rows_ * (1.0f - ndc_y);
    if (!(column >= 0.0f && row >= 0.0f && column <= last_column_ && row <= last_row_)) return std::nullopt;
    const int i = std::min(static_cast<int>(column), grid_.nx - 2), j = std::min(static_cast<int>(row), grid_.ny - 2);
    if (!cells_[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid_.nx - 1) + static_cast<std::size_t>(i)])
      return std::nullopt;
    const float u = column - static_cast<float>(i), v = row - static_cast<float>(j);
    const float w[4] = {(1.0f - u) * (1.0f - v), u * (1.0f - v), (1.0f - u) * v, u * v};
    const Node* upper = &nodes_[grid_.index(i, j)];
    const Node* corners[4] = {upper, upper + 1, upper + grid_.nx, upper + grid_.nx + 1};
    float x[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    for (int n = 0; n < 4; ++n) {
      const Node& node = *corners[n];
      for (int c = 0; c < 4; ++c)
        x[c] += w[n] * (vergence_D * node.a[c] + node.b[c] - accommodation_D * (vergence_D * node.q0[c] + node.q1[c]));
    }
    return Eigen::Matrix2f{{x[0], x[1]}, {x[2], x[3]}};
  }

 private:
  void find_usable_cells();

  FieldGrid grid_;
  float half_columns_, half_rows_, last_column_, last_row_;
  std::vector<Node> nodes_;
  std::vector<std::uint8_t> usable_, cells_;  ///< of directions; of cells: all four corners are usable
};

}  // namespace sturm
