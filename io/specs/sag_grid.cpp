#include "io/specs/sag_grid.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "io/files/csv_table.h"
#include "io/files/error.h"
#include "io/files/text_encoding.h"
#include "io/files/text_file.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr std::size_t fewest_points = 16;
constexpr int most_cells = 256;      // each way: the normal equations of a fit grow with their number to the power 1.5
constexpr double same_place = 1e-9;  // [m]

struct Row {
  Eigen::Vector3d point;  // [m]
  int line;               // 0: not of a table
};

[[noreturn]] void fail(const std::string& file, int line, const std::string& got, const std::string& expected) {
  throw InputError(file, line > 0 ? "line " + std::to_string(line) : "", got, expected);
}

std::string number_text(double value) {
  std::array<char, 32> text;
  return {text.data(),
          std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 12).ptr};
}

std::string place_text(const Eigen::Vector2d& at) {
  return "(" + number_text(at.x() / metres_per_millimetre) + ", " + number_text(at.y() / metres_per_millimetre) +
         ") mm";
}

using Columns = std::array<std::size_t, 3>;

const CsvColumn x_column{"x_mm", {"x"}}, y_column{"y_mm", {"y"}};
const CsvColumn z_column{"z_mm", {"z", "sag", "sagmm", "height", "heightmm"}};

Columns columns_of(const CsvTable& table) {
  const auto x = table.find(x_column), y = table.find(y_column), z = table.find(z_column);
  if (!x || !y || !z) {
    const auto& names = table.heading().fields;
    table.fail(table.heading().line, "\"" + shortened(names[0], 40) + (names.size() > 1 ? ", …\"" : "\""),
               "a line of column names with x_mm, y_mm and z_mm (or sag_mm)");
  }
  return {*x, *y, *z};
}

double number_in(const std::string& cell, const CsvTable& table, int line) {
  const std::optional<double> value = csv_number(cell);
  if (!value || !std::isfinite(*value)) table.fail(line, "\"" + shortened(cell, 40) + "\"", "a finite number [mm]");
  return metres_per_millimetre * *value;
}

std::vector<Row> rows_of(const std::string& file) {
  std::optional<std::string> contents = file_contents(file);
  if (!contents) fail(file, 0, "a file that cannot be read", "a table of x_mm, y_mm, z_mm");
  CsvTable table(std::move(*contents), file);
  const Columns columns = columns_of(table);
  const std::size_t last = *std::ranges::max_element(columns);
  std::vector<Row> rows;
  while (const std::optional<CsvRow> row = table.next()) {
    const std::vector<std::string>& cells = row->fields;
    if (cells.size() <= last)
      table.fail(row->line, std::to_string(cells.size()) + " values", "at least " + std::to_string(last + 1));
    const auto number = [&](std::size_t column) { return number_in(cells[column], table, row->line); };
    rows.push_back({{number(columns[0]), number(columns[1]), number(columns[2])}, row->line});
  }
  if (rows.size() < fewest_points)
    fail(file, 0, std::to_string(rows.size()) + " points",
         "at least " + std::to_string(fewest_points) + " points of the surface");
  return rows;
}

/// Sorted by x, then y.
void sort_and_refuse_duplicates(std::vector<Row>& rows, const std::string& file) {
  std::ranges::sort(rows, [](const Row& a, const Row& b) {
    return std::pair(a.point.x(), a.point.y()) < std::pair(b.point.x(), b.point.y());
  });
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = i + 1; j < rows.size() && rows[j].point.x() - rows[i].point.x() < same_place; ++j)
      if (std::abs(rows[j].point.y() - rows[i].point.y()) < same_place)
        fail(file, std::max(rows[i].line, rows[j].line), "the point " + place_text(rows[j].point.head<2>()) + " again",
             rows[i].line == 0
                 ? "each point once"
                 : "each point once; line " + std::to_string(std::min(rows[i].line, rows[j].line)) + " has it");
}

/// The grid whose knots the points are, if they are all of a regular grid's.
std::optional<KnotGrid> complete_grid(const std::vector<Row>& rows) {
  std::size_t ny = 1;
  while (ny < rows.size() && rows[ny].point.x() - rows[0].point.x() < same_place) ++ny;
  const std::size_t nx = rows.size() / ny;
  if (nx * ny != rows.size() || nx < 4 || ny < 4) return std::nullopt;
  const Eigen::Vector2d first = rows.front().point.head<2>(), last = rows.back().point.head<2>();
  const KnotGrid grid{first, (last - first).cwiseQuotient(Eigen::Vector2d(double(nx - 1), double(ny - 1))),
                      static_cast<int>(nx) - 1, static_cast<int>(ny) - 1};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Eigen::Vector2d knot = first + grid.spacing.cwiseProduct(Eigen::Vector2d(double(i / ny), double(i % ny)));
    if (!((rows[i].point.head<2>() - knot).cwiseAbs().maxCoeff() < same_place)) return std::nullopt;
  }
  return grid.spacing.minCoeff() > 0.0 ? std::optional(grid) : std::nullopt;
}

KnotGrid grid_for_fit(const std::vector<Eigen::Vector3d>& points, std::optional<double> knot_spacing,
                      const std::string& file) {
  Eigen::Vector2d low = points[0].head<2>(), high = low;
  for (const Eigen::Vector3d& p : points) low = low.cwiseMin(p.head<2>()), high = high.cwiseMax(p.head<2>());
  const Eigen::Vector2d size = high - low;
  if (!(size.minCoeff() > 0.0)) fail(file, 0, "points on one line", "points that cover the surface");
  const double spacing = knot_spacing.value_or(1.5 * std::sqrt(size.prod() / static_cast<double>(points.size())));
  const Eigen::Vector2d cells = (size / spacing * (1.0 - 1e-12)).array().ceil().max(3.0);
  if (cells.maxCoeff() > most_cells)
    fail(file, 0,
         "a knot spacing of " + number_text(spacing / metres_per_millimetre) + " mm for points over " +
             number_text(size.maxCoeff() / metres_per_millimetre) + " mm",
         "a knot spacing of at least " + number_text(size.maxCoeff() / most_cells / metres_per_millimetre) + " mm");
  return {low, size.cwiseQuotient(cells), static_cast<int>(cells.x()), static_cast<int>(cells.y())};
}

/// Every cell within the rim needs a point near its middle.
void refuse_gaps(const KnotGrid& grid, const std::vector<Eigen::Vector3d>& points, double rim_radius,
                 const std::string& file) {
  const auto cell = [&](double at, double first, double spacing, int cells) {
    return std::clamp(static_cast<int>(std::floor((at - first) / spacing)), 0, cells - 1);
  };
  std::vector<std::vector<Eigen::Vector2d>> bins(static_cast<std::size_t>(grid.cells_x) *
                                                 static_cast<std::size_t>(grid.cells_y));
  const auto bin = [&](int i, int j) -> auto& {
    return bins[static_cast<std::size_t>(i) * static_cast<std::size_t>(grid.cells_y) + static_cast<std::size_t>(j)];
  };
  for (const Eigen::Vector3d& p : points)
    bin(cell(p.x(), grid.first.x(), grid.spacing.x(), grid.cells_x),
        cell(p.y(), grid.first.y(), grid.spacing.y(), grid.cells_y))
        .push_back(p.head<2>());
  for (int i = 0; i < grid.cells_x; ++i)
    for (int j = 0; j < grid.cells_y; ++j) {
      const Eigen::Vector2d middle = grid.first + grid.spacing.cwiseProduct(Eigen::Vector2d(i + 0.5, j + 0.5));
      if (middle.norm() > rim_radius) continue;
      bool near = false;
      for (int k = std::max(0, i - 2); k <= std::min(grid.cells_x - 1, i + 2) && !near; ++k)
        for (int l = std::max(0, j - 2); l <= std::min(grid.cells_y - 1, j + 2) && !near; ++l)
          near = std::ranges::any_of(bin(k, l), [&](const Eigen::Vector2d& p) {
            return (p - middle).cwiseQuotient(grid.spacing).norm() <= 1.5;
          });
      if (!near)
        fail(file, 0, "a gap: no point near " + place_text(middle),
             "a point within 1.5 knot spacings (of " + number_text(grid.spacing.maxCoeff() / metres_per_millimetre) +
                 " mm) of every place within the rim, or a larger knot_spacing_mm, or a smaller diameter_mm");
    }
}

BSplineSurface lifted(const KnotGrid& grid, const BSplineSurface& surface, const std::string& file) {
  const auto vertex = surface.sag(0.0, 0.0);
  if (!vertex)
    fail(file, 0, "points from " + place_text(grid.first) + " to " + place_text(grid.last()),
         "points about the lens's axis at (0, 0)");
  return surface.raised(-vertex->value);
}

SagGrid surface_through(std::vector<Row> rows, std::optional<double> knot_spacing_m, double rim_radius,
                        const std::string& file) {
  sort_and_refuse_duplicates(rows, file);
  std::vector<Eigen::Vector3d> points;
  for (const Row& row : rows) points.push_back(row.point);
  if (const auto grid = complete_grid(rows); grid && !knot_spacing_m) {
    Eigen::MatrixXd heights(grid->cells_x + 1, grid->cells_y + 1);
    for (std::size_t i = 0; i < points.size(); ++i)
      heights(static_cast<Eigen::Index>(i) / heights.cols(), static_cast<Eigen::Index>(i) % heights.cols()) =
          points[i].z();
    const BSplineSurface surface = BSplineSurface::interpolating(*grid, heights);
    return {lifted(*grid, surface, file), residual_at(surface, points), points.size()};
  }
  const KnotGrid grid = grid_for_fit(points, knot_spacing_m, file);
  refuse_gaps(grid, points, rim_radius, file);
  try {
    const BSplineFit fit = fitted_bspline(grid, points);
    return {lifted(grid, fit.surface, file), fit.residual, points.size()};
  } catch (const std::logic_error& error) {
    fail(file, 0, error.what(), "points that cover the surface");
  }
}

}  // namespace

SagGrid read_sag_grid(const std::string& file, std::optional<double> knot_spacing_m, double rim_radius) {
  return surface_through(rows_of(file), knot_spacing_m, rim_radius, file);
}

SagGrid sag_surface(const std::vector<Eigen::Vector3d>& points, std::optional<double> knot_spacing_m, double rim_radius,
                    const std::string& file) {
  std::vector<Row> rows;
  for (const Eigen::Vector3d& point : points) rows.push_back({point, 0});
  if (rows.size() < fewest_points)
    fail(file, 0, std::to_string(rows.size()) + " points",
         "at least " + std::to_string(fewest_points) + " points of the surface");
  return surface_through(std::move(rows), knot_spacing_m, rim_radius, file);
}

}  // namespace sturm
