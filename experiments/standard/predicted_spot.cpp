#include "experiments/standard/predicted_spot.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "conoid/pictures/ellipse_kernel.h"

namespace sturm {

namespace {

/// Points that stand for the light, on Vogel's spiral. What a pixel gets from a point of the light is continuous in the
/// point, except within a focal line; the mean over so many of them is off by some 1e-3 of the peak on the rim of the
/// ellipse and exact inside.
constexpr int points_of_light = 512;
constexpr double golden_angle = std::numbers::pi * (3.0 - 2.2360679774997896964);
constexpr double first_angle =
    1.0;  // rad; turned so that no point has a whole number as a coordinate, where a pixel would end

}  // namespace

Image predicted_spot(const Eigen::Matrix2d& map, double light_radius_px, int resolution) {
  const Eigen::Matrix2d down = Eigen::Vector2d(1.0, -1.0).asDiagonal() * map;  // rows count downwards
  const double share = std::numbers::pi * light_radius_px * light_radius_px / points_of_light;
  std::vector<double> sums(static_cast<std::size_t>(resolution) * static_cast<std::size_t>(resolution), 0.0);
  for (int i = 0; i < points_of_light; ++i) {
    const double r = light_radius_px * std::sqrt((i + 0.5) / points_of_light), angle = first_angle + golden_angle * i;
    const Eigen::Vector2d at(0.5 * resolution + r * std::cos(angle), 0.5 * resolution + r * std::sin(angle));
    const Eigen::Vector2d corner = at.array().floor();
    const EllipseKernel kernel(down, at - corner);
    int y = static_cast<int>(corner.y()) + kernel.first_row();
    for (const EllipseKernel::Row& row : kernel.rows()) {
      const auto put = [&](int column, double weight) {
        const int x = static_cast<int>(corner.x()) + column;
        if (x >= 0 && x < resolution && y >= 0 && y < resolution)
          sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(resolution) + static_cast<std::size_t>(x)] +=
              share * weight;
      };
      std::size_t edge = row.edges;
      for (int x = row.begin; x < row.inner_begin; ++x) put(x, kernel.edge_weights()[edge++]);
      for (int x = row.inner_begin; x < row.inner_end; ++x) put(x, kernel.inner_weight());
      for (int x = row.inner_end; x < row.end; ++x) put(x, kernel.edge_weights()[edge++]);
      ++y;
    }
  }
  Image picture(resolution, resolution, 3);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) picture.pixels[i] = static_cast<float>(sums[i / 3]);
  return picture;
}

}  // namespace sturm
