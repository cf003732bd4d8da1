#include "lensmodel/progressive.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sturm {

namespace {

Sag closed_form(const ProgressiveSurface& surface, double x, double y) {
  const auto there = surface.sag(x, y);
  if (!there) throw std::domain_error("the progressive surface ends before the rim");
  return *there;
}

BSplineSurface as_spline(const ProgressiveSurface& surface, const KnotGrid& grid) {
  Eigen::MatrixXd heights(grid.cells_x + 1, grid.cells_y + 1);
  for (int i = 0; i <= grid.cells_x; ++i)
    for (int j = 0; j <= grid.cells_y; ++j)
      heights(i, j) =
          closed_form(surface, grid.first.x() + i * grid.spacing.x(), grid.first.y() + j * grid.spacing.y()).value;
  return BSplineSurface::interpolating(grid, heights);
}

SurfacePower largest_difference(const ProgressiveSurface& exact, const BSplineSurface& spline, double index,
                                double radius) {
  constexpr int places = 200;
  const KnotGrid& grid = spline.grid();
  const int stride = std::max(1, grid.cells_x / places);
  SurfacePower worst{0.0, 0.0};
  for (int i = 0; i < grid.cells_x; i += stride)
    for (int j = 0; j < grid.cells_y; j += stride)
      for (const double part : {0.0, 0.5}) {
        const double x = grid.first.x() + (i + part) * grid.spacing.x(),
                     y = grid.first.y() + (j + part) * grid.spacing.y();
        if (std::hypot(x, y) > radius) continue;
        const SurfacePower a = surface_power(closed_form(exact, x, y), index),
                           b = surface_power(spline.sag(x, y).value(), index);
        worst.mean_D = std::fmax(worst.mean_D, std::abs(a.mean_D - b.mean_D));
        worst.cylinder_D = std::fmax(worst.cylinder_D, std::abs(a.cylinder_D - b.cylinder_D));
      }
  return worst;
}

}  // namespace

ProgressiveSurface progressive_front(const Prescription& rx, const ProgressiveDesign& design) {
  return ProgressiveSurface({.far_power_D = design.lens.base_curve_D.value_or(usual_base_curve_D(rx)),
                             .addition_D = design.addition_D,
                             .refractive_index = design.lens.refractive_index,
                             .corridor_start_m = design.corridor_start_m,
                             .corridor_length_m = design.corridor_length_m,
                             .near_shift_m = design.near_shift_m,
                             .zone_width_m = design.zone_width_m});
}

ProgressiveLens progressive_lens(const Prescription& rx, const ProgressiveDesign& design) {
  const ProgressiveSurface front = progressive_front(rx, design);
  const double radius = 0.5 * design.lens.diameter_m;
  // Two knots beyond the rim: the spline is least exact in its outermost cells.
  const KnotGrid grid = KnotGrid::centred(radius + 2.0 * design.knot_spacing_m, design.knot_spacing_m);
  const BSplineSurface spline = as_spline(front, grid);
  ProgressiveLens made{single_vision(rx, design.lens),
                       largest_difference(front, spline, design.lens.refractive_index, radius), grid.spacing.x()};
  made.lens.front = spline;
  return made;
}

}  // namespace sturm
