#include "lensmodel/bspline_surface.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace sturm {

namespace {

constexpr int fewest_cells = 3;  // four heights in a row make a cubic

/// Coefficients of the splines through the columns of `heights`, whose rows are knots: c₋₁ … c_{N+1} for f₀ … f_N.
/// With second differences δ²: c + δ²c/6 = f at every knot, and "not a knot" is δ⁴c = 0 at the knots 1 and N − 1.
/// Therefore δ²c = δ²f and c = f − δ²f/6 there; between those two the system is tridiagonal, outside of them it is
/// solved knot by knot.
Eigen::MatrixXd coefficients_along_rows(const Eigen::MatrixXd& f) {
  const Eigen::Index n = f.rows() - 1;
  Eigen::MatrixXd c(n + 3, f.cols());
  const auto at = [&](Eigen::Index i) { return c.row(i + 1); };
  const auto bend = [&](Eigen::Index i) -> Eigen::RowVectorXd { return f.row(i - 1) - 2.0 * f.row(i) + f.row(i + 1); };
  at(1) = f.row(1) - bend(1) / 6.0;
  at(n - 1) = f.row(n - 1) - bend(n - 1) / 6.0;
  // Thomas's algorithm for c_{i−1} + 4c_i + c_{i+1} = 6f_i, i = 2 … n − 2.
  std::vector<double> upper(static_cast<std::size_t>(n) + 1, 0.0);
  for (Eigen::Index i = 2; i <= n - 2; ++i) {
    const double pivot = 1.0 / (4.0 - upper[static_cast<std::size_t>(i - 1)]);
    upper[static_cast<std::size_t>(i)] = pivot;
    at(i) = pivot * (6.0 * f.row(i) - at(i - 1));
  }
  for (Eigen::Index i = n - 2; i >= 2; --i) at(i) -= upper[static_cast<std::size_t>(i)] * at(i + 1);
  at(0) = 2.0 * at(1) - at(2) + bend(1);
  at(n) = 2.0 * at(n - 1) - at(n - 2) + bend(n - 1);
  at(-1) = 6.0 * f.row(0) - 4.0 * at(0) - at(1);
  at(n + 1) = 6.0 * f.row(n) - 4.0 * at(n) - at(n - 1);
  return c;
}

void require_usable(const KnotGrid& grid) {
  if (grid.cells_x < fewest_cells || grid.cells_y < fewest_cells)
    throw std::invalid_argument("a B-spline surface needs at least 3 × 3 cells");
  if (!(grid.spacing.minCoeff() > 0.0) || !grid.spacing.allFinite() || !grid.first.allFinite())
    throw std::invalid_argument("the knots of a B-spline surface need a finite spacing > 0");
}

}  // namespace

KnotGrid KnotGrid::centred(double reach, double spacing) {
  const int half = std::max(2, static_cast<int>(std::ceil(reach / spacing * (1.0 - 1e-12))));
  const double h = std::fmin(spacing, reach / half);
  return {Eigen::Vector2d::Constant(-half * h), Eigen::Vector2d::Constant(h), 2 * half, 2 * half};
}

BSplineSurface BSplineSurface::interpolating(const KnotGrid& grid, const Eigen::MatrixXd& heights) {
  require_usable(grid);
  if (heights.rows() != grid.cells_x + 1 || heights.cols() != grid.cells_y + 1)
    throw std::invalid_argument("a B-spline surface needs one height for each knot");
  return {grid, coefficients_along_rows(coefficients_along_rows(heights).transpose()).transpose()};
}

BSplineSurface::BSplineSurface(const KnotGrid& grid, const Eigen::MatrixXd& coefficients) {
  require_usable(grid);
  if (coefficients.rows() != grid.cells_x + 3 || coefficients.cols() != grid.cells_y + 3)
    throw std::invalid_argument("a B-spline surface needs (cells + 3) coefficients each way");
  if (!coefficients.allFinite()) throw std::invalid_argument("a height of a B-spline surface is not finite");
  data_ = std::make_shared<const Data>(Data{grid, coefficients, coefficients.minCoeff(), coefficients.maxCoeff()});
}

BSplineSurface BSplineSurface::raised(double height) const {
  return {data_->grid, data_->coefficients.array() + height};  // the splines add up to 1
}

std::optional<BSplineSurface::Cell> BSplineSurface::cell_at(double x, double y) const {
  const KnotGrid& grid = data_->grid;
  const double u = (x - grid.first.x()) / grid.spacing.x(), v = (y - grid.first.y()) / grid.spacing.y();
  if (!(u >= 0.0 && u <= grid.cells_x && v >= 0.0 && v <= grid.cells_y)) return std::nullopt;
  const int i = std::min(static_cast<int>(u), grid.cells_x - 1), j = std::min(static_cast<int>(v), grid.cells_y - 1);
  return Cell{i, j, CubicBasis(u - i), CubicBasis(v - j)};
}

template <bool curved>
Sag BSplineSurface::sag(const Cell& cell) const {
  double z = 0.0, zx = 0.0, zy = 0.0, zxx = 0.0, zxy = 0.0, zyy = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double* row = &data_->coefficients(cell.i + static_cast<int>(k), cell.j);
    double value = 0.0, first = 0.0, second = 0.0;
    for (std::size_t l = 0; l < 4; ++l) {
      value += row[l] * cell.y.value[l];
      first += row[l] * cell.y.first[l];
      if constexpr (curved) second += row[l] * cell.y.second[l];
    }
    z += cell.x.value[k] * value;
    zx += cell.x.first[k] * value;
    zy += cell.x.value[k] * first;
    if constexpr (curved) {
      zxx += cell.x.second[k] * value;
      zxy += cell.x.first[k] * first;
      zyy += cell.x.value[k] * second;
    }
  }
  const double hx = 1.0 / data_->grid.spacing.x(), hy = 1.0 / data_->grid.spacing.y();
  Sag result;
  result.value = z;
  result.gradient << zx * hx, zy * hy;
  if constexpr (curved) result.hessian << zxx * hx * hx, zxy * hx * hy, zxy * hx * hy, zyy * hy * hy;
  return result;
}

std::optional<SagSlope> BSplineSurface::slope(double x, double y) const {
  const auto cell = cell_at(x, y);
  if (!cell) return std::nullopt;
  const Sag flat = sag<false>(*cell);
  return SagSlope{flat.value, flat.gradient};
}

std::optional<Sag> BSplineSurface::sag(double x, double y) const {
  const auto cell = cell_at(x, y);
  return cell ? std::optional(sag<true>(*cell)) : std::nullopt;
}

}  // namespace sturm
