#include "lensmodel/bspline_fit.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "lensmodel/cubic_basis.h"

namespace sturm {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Weight of a squared fourth difference against a squared residual of one point. Small enough not to flatten a lens
/// (see the tests), large enough for the factorisation.
constexpr double roughness_weight = 1e-6;

struct Cell {
  int i, j;
  CubicBasis x, y;
};

Cell cell_of(const KnotGrid& grid, const Eigen::Vector3d& point) {
  // A point on the border may lie outside by the rounding of the border.
  constexpr double slack = 1e-9;
  const Eigen::Vector2d at = (point.head<2>() - grid.first).cwiseQuotient(grid.spacing);
  if (!(point.allFinite() && at.minCoeff() >= -slack && at.x() <= grid.cells_x + slack &&
        at.y() <= grid.cells_y + slack))
    throw std::invalid_argument("a point of the fit lies outside of its grid or is not finite");
  const double u = std::clamp(at.x(), 0.0, double(grid.cells_x)), v = std::clamp(at.y(), 0.0, double(grid.cells_y));
  const int i = std::min(static_cast<int>(u), grid.cells_x - 1), j = std::min(static_cast<int>(v), grid.cells_y - 1);
  return {i, j, CubicBasis(u - i), CubicBasis(v - j)};
}

/// Rows of the least squares problem: one for each point, then one for each fourth difference.
Eigen::SparseMatrix<double> design_matrix(const KnotGrid& grid, std::span<const Eigen::Vector3d> points) {
  const int nx = grid.cells_x + 3, ny = grid.cells_y + 3;
  Triplets entries;
  int row = 0;
  for (const Eigen::Vector3d& point : points) {
    const Cell cell = cell_of(grid, point);
    for (int k = 0; k < 4; ++k)
      for (int l = 0; l < 4; ++l)
        entries.emplace_back(row, (cell.i + k) * ny + cell.j + l,
                             cell.x.value[static_cast<std::size_t>(k)] * cell.y.value[static_cast<std::size_t>(l)]);
    ++row;
  }
  constexpr std::array<double, 5> fourth_difference{1.0, -4.0, 6.0, -4.0, 1.0};
  const double weight = std::sqrt(roughness_weight);
  const auto add_difference = [&](int first, int step) {
    for (int k = 0; k < 5; ++k)
      entries.emplace_back(row, first + k * step, weight * fourth_difference[static_cast<std::size_t>(k)]);
    ++row;
  };
  for (int i = 0; i + 4 < nx; ++i)
    for (int j = 0; j < ny; ++j) add_difference(i * ny + j, ny);
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j + 4 < ny; ++j) add_difference(i * ny + j, 1);
  Eigen::SparseMatrix<double> matrix(row, nx * ny);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

FitResidual residual_at(const BSplineSurface& surface, std::span<const Eigen::Vector3d> points) {
  const Eigen::Vector2d low = surface.grid().first, high = surface.grid().last();
  FitResidual residual;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector2d at = point.head<2>().cwiseMax(low).cwiseMin(high);
    // The far border may lie one rounding beyond the last knot.
    const auto there = surface.sag(at.x(), at.y());
    const double off =
        (there ? there->value : surface.sag(std::nextafter(at.x(), low.x()), std::nextafter(at.y(), low.y()))->value) -
        point.z();
    residual.rms += off * off;
    residual.max = std::fmax(residual.max, std::abs(off));
  }
  residual.rms = std::sqrt(residual.rms / static_cast<double>(points.size()));
  return residual;
}

BSplineFit fitted_bspline(const KnotGrid& grid, std::span<const Eigen::Vector3d> points) {
  if (points.size() < 16) throw std::domain_error("fewer than 16 points do not determine a surface");
  const Eigen::SparseMatrix<double> matrix = design_matrix(grid, points);
  Eigen::VectorXd heights = Eigen::VectorXd::Zero(matrix.rows());
  for (std::size_t i = 0; i < points.size(); ++i) heights[static_cast<Eigen::Index>(i)] = points[i].z();
  const Eigen::SparseMatrix<double> normal = matrix.transpose() * matrix;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(normal);
  const auto undetermined = [&] {
    const Eigen::VectorXd pivots = solver.vectorD();
    return !(pivots.minCoeff() > 1e-14 * pivots.maxCoeff());
  };
  if (solver.info() != Eigen::Success || undetermined())
    throw std::domain_error("the points do not determine a surface");
  Eigen::VectorXd coefficients = solver.solve(matrix.transpose() * heights);
  // The normal equations square the condition number: what rounding left over is solved for once more.
  for (int i = 0; i < 2; ++i)
    coefficients += solver.solve(matrix.transpose() * (heights - matrix * coefficients)).eval();
  const Eigen::MatrixXd table = coefficients.reshaped<Eigen::RowMajor>(grid.cells_x + 3, grid.cells_y + 3);
  BSplineSurface surface(grid, table);
  const FitResidual residual = residual_at(surface, points);
  return {std::move(surface), residual};
}

}  // namespace sturm
