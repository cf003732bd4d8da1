#include "conoid/blur_field/depth_analytic_field.h"

#include <stdexcept>

#include "conoid/blur_field/rows.h"

namespace sturm {

DepthAnalyticField::DepthAnalyticField(const FieldGrid& grid, const TracedDirections& directions,
                                       const PowerMatrix& correction)
    : DepthAnalyticField(
          grid,
          [&] {
            const Eigen::Matrix2d f = correction.matrix();
            std::vector<Node> nodes(directions.conoids.size(), Node{});
            for (std::size_t n = 0; n < nodes.size(); ++n) {
              const SpectacleConoid& conoid = directions.conoids[n];
              if (conoid.status != LensStatus::ok) continue;
              store_rows(conoid.exit.offsets(f), nodes[n].a);
              store_rows(conoid.exit.slopes(f), nodes[n].b);
              store_rows(conoid.exit.offset_from_slope, nodes[n].q0);
              store_rows(conoid.exit.slope_from_slope, nodes[n].q1);
            }
            return nodes;
          }(),
          [&] {
            std::vector<std::uint8_t> usable;
            usable.reserve(directions.conoids.size());
            for (const SpectacleConoid& conoid : directions.conoids) usable.push_back(conoid.status == LensStatus::ok);
            return usable;
          }()) {}

DepthAnalyticField::DepthAnalyticField(const FieldGrid& grid, std::vector<Node> nodes, std::vector<std::uint8_t> usable)
    : grid_(grid),
      half_columns_(0.5f * static_cast<float>(grid.nx - 1)),
      half_rows_(0.5f * static_cast<float>(grid.ny - 1)),
      last_column_(static_cast<float>(grid.nx - 1)),
      last_row_(static_cast<float>(grid.ny - 1)),
      nodes_(std::move(nodes)),
      usable_(std::move(usable)) {
  if (nodes_.size() != grid.directions() || usable_.size() != grid.directions())
    throw std::invalid_argument("a blur field whose directions do not fit its grid");
  find_usable_cells();
}

void DepthAnalyticField::find_usable_cells() {
  for (int j = 0; j + 1 < grid_.ny; ++j)
    for (int i = 0; i + 1 < grid_.nx; ++i) {
      const std::size_t at = grid_.index(i, j), below = grid_.index(i, j + 1);
      cells_.push_back(usable_[at] && usable_[at + 1] && usable_[below] && usable_[below + 1]);
    }
}

}  // namespace sturm
