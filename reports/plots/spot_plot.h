#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "lensmodel/ellipse.h"
#include "reports/plots/plot.h"

namespace sturm {

/// Where the rays of one point source land, as angles about the chief ray.
struct SpotDiagram {
  double distance_m = 0.0;                             ///< of the source, ∞ allowed
  std::vector<Eigen::Vector2d> points;                 ///< [arcmin], wearer frame
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();  ///< [arcmin], of all rays, not of these points
  Ellipse ellipse;                                     ///< of the same second moments [arcmin]
};

/// Spot diagrams through focus, side by side on one scale: as the wearer sees a point of light. `range_arcmin` is half
/// the width of a panel; none: what all rays need.
Plot spot_plot(std::span<const SpotDiagram> spots, std::optional<double> range_arcmin = std::nullopt);

}  // namespace sturm
