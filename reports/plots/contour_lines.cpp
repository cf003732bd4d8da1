#include "reports/plots/contour_lines.h"

#include <cmath>

namespace sturm {

std::vector<ContourPiece> contour_lines(const Eigen::MatrixXd& values, double level) {
  std::vector<ContourPiece> pieces;
  for (Eigen::Index row = 0; row + 1 < values.rows(); ++row)
    for (Eigen::Index column = 0; column + 1 < values.cols(); ++column) {
      // Counter-clockwise from (column, row), with side k from corner k to corner k + 1.
      const Eigen::Vector2d origin{double(column), double(row)};
      const std::array<Eigen::Vector2d, 4> corner{origin, origin + Eigen::Vector2d(1, 0),
                                                  origin + Eigen::Vector2d(1, 1), origin + Eigen::Vector2d(0, 1)};
      const std::array<double, 4> above{values(row, column) - level, values(row, column + 1) - level,
                                        values(row + 1, column + 1) - level, values(row + 1, column) - level};
      const double mean = 0.25 * (above[0] + above[1] + above[2] + above[3]);
      if (!std::isfinite(mean)) continue;
      std::vector<Eigen::Vector2d> crossings;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t next = (k + 1) % 4;
        if ((above[k] >= 0.0) == (above[next] >= 0.0)) continue;
        const double t = above[k] / (above[k] - above[next]);
        crossings.push_back(corner[k] + t * (corner[next] - corner[k]));
      }
      if (crossings.size() == 2) {
        pieces.push_back({crossings[0], crossings[1]});
      } else if (crossings.size() == 4) {  // cut off the corners that are on the other side than the middle
        const std::size_t first = (above[0] >= 0.0) == (mean >= 0.0) ? 0 : 3;
        pieces.push_back({crossings[first], crossings[(first + 1) % 4]});
        pieces.push_back({crossings[(first + 2) % 4], crossings[(first + 3) % 4]});
      }
    }
  return pieces;
}

}  // namespace sturm
