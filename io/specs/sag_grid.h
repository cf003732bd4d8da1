#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lensmodel/bspline_fit.h"

namespace sturm {

/// A surface that was measured or computed elsewhere.
struct SagGrid {
  BSplineSurface surface;  ///< its height at (0, 0) is 0
  FitResidual residual;    ///< of the points
  std::size_t points;
};

/// Reads a table (io/files/csv_table.h) with a line of column names, x_mm, y_mm and z_mm (or sag_mm) among them.
/// Surface frame, mm. A complete regular grid is interpolated unless a knot spacing is given. Anything else is fitted
/// (lensmodel/bspline_fit.h) on knots `knot_spacing_m` apart, by default 1.5 times the mean distance of the points. The
/// constant height at (0, 0) is taken off, so that the lens has its thickness there; a slope there stays. `rim_radius`
/// [m]: within it there must be points everywhere within the points' bounding box, no further from the middle of any
/// cell than 1.5 knot spacings. Throws InputError with file and line.
SagGrid read_sag_grid(const std::string& file, std::optional<double> knot_spacing_m, double rim_radius);

/// The same for points (x, y, z) [m] that come from elsewhere in `file`.
SagGrid sag_surface(const std::vector<Eigen::Vector3d>& points, std::optional<double> knot_spacing_m, double rim_radius,
                    const std::string& file);

}  // namespace sturm
