#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

namespace sturm {

/// One piece of a contour line within one cell of a grid, in grid coordinates (column, row).
using ContourPiece = std::array<Eigen::Vector2d, 2>;

/// Where `values`, interpolated along the sides of the cells ("marching squares"), cross `level`. values(row, column);
/// a cell with a value that is not finite has none. A saddle is cut as the mean of its corners says.
std::vector<ContourPiece> contour_lines(const Eigen::MatrixXd& values, double level);

/// A whole line, end to end; closed where its first point is its last.
using ContourLine = std::vector<Eigen::Vector2d>;

/// The pieces put together to lines as long as they can be, in the order of their first pieces.
std::vector<ContourLine> joined(const std::vector<ContourPiece>& pieces);

}  // namespace sturm
