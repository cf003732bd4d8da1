#pragma once
#include <Eigen/Core>
#include <memory>
#include <optional>

#include "lensmodel/cubic_basis.h"
#include "lensmodel/sag.h"

namespace sturm {

/// Knots of a B-spline surface: the corners of cells_x × cells_y equal cells [m], surface frame.
struct KnotGrid {
  Eigen::Vector2d first;    ///< the knot with the least x and y
  Eigen::Vector2d spacing;  ///< > 0
  int cells_x = 0, cells_y = 0;

  Eigen::Vector2d last() const { return first + spacing.cwiseProduct(Eigen::Vector2d(cells_x, cells_y)); }

  /// Square cells of about `spacing` (never wider) that cover |x|, |y| ≤ reach, with a knot at the origin.
  static KnotGrid centred(double reach, double spacing);
};

/// A free-form surface: bicubic tensor-product spline on a uniform grid of knots, twice continuously differentiable.
/// Copies share the coefficients.
class BSplineSurface {
 public:
  /// The spline through heights[i, j] = z at the knot (first + (i, j)·spacing). At each border the third derivative is
  /// continuous across the first inner knot ("not a knot"), which reproduces bicubic polynomials exactly and keeps the
  /// order of convergence up to the border: h⁴ in height, h² in curvature. Throws std::invalid_argument unless there
  /// are at least 3 × 3 cells and the heights fit and are finite.
  static BSplineSurface interpolating(const KnotGrid& grid, const Eigen::MatrixXd& heights);

  /// The spline with these coefficients, (cells_x + 3) × (cells_y + 3); the value at a knot is their (1, 4, 1)/6
  /// average.
  BSplineSurface(const KnotGrid& grid, const Eigen::MatrixXd& coefficients);

  /// z(x, y); none beyond the grid.
  std::optional<Sag> sag(double x, double y) const;
  std::optional<SagSlope> slope(double x, double y) const;

  /// The same surface, higher by `height` [m].
  BSplineSurface raised(double height) const;

  /// No point of the surface lies outside of these heights (that is the property of the coefficients' convex hull).
  double lowest() const { return data_->lowest; }
  double highest() const { return data_->highest; }

  const KnotGrid& grid() const { return data_->grid; }

  /// (cells_x + 3) × (cells_y + 3) [m], rows along x; the spline with these is this surface to the last bit.
  using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Coefficients& coefficients() const { return data_->coefficients; }

 private:
  /// The cell of a point, and its place in it; none beyond the grid.
  struct Cell {
    int i, j;
    CubicBasis x, y;
  };
  std::optional<Cell> cell_at(double x, double y) const;

  /// At a place; without its hessian unless `curved`.
  template <bool curved>
  Sag sag(const Cell& cell) const;

  struct Data {
    KnotGrid grid;
    Coefficients coefficients;
    double lowest, highest;
  };
  std::shared_ptr<const Data> data_;
};

}  // namespace sturm
