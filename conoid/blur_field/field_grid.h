#pragma once
#include <Eigen/Core>

namespace sturm {

/// The grid of a blur field in normalised device coordinates: nx × ny lines of sight over a perspective field of view,
/// the outer ones on its edge, and nz distances, uniform in dioptres from `near_vergence_D` to `far_vergence_D`, both
/// included. Index (0, 0) is the upper left line of sight as the wearer sees it. [Kakimoto2010] §4
struct FieldGrid {
  int nx = 32, ny = 32, nz = 256;                      ///< ≥ 2 each
  double tan_half_width = 1.0, tan_half_height = 1.0;  ///< of the field of view
  double near_vergence_D = 4.0, far_vergence_D = 0.0;  ///< near > far ≥ 0; 0 is infinity

  std::size_t directions() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }  ///< nx·ny
  std::size_t voxels() const { return directions() * static_cast<std::size_t>(nz); }  ///< nx·ny·nz
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i);
  }  ///< number of a direction: row by row

  /// Normalised coordinates: −1 left edge … 1 right edge; −1 lower edge … 1 upper edge.
  double ndc_x(int i) const { return 2.0 * i / (nx - 1) - 1.0; }
  double ndc_y(int j) const { return 1.0 - 2.0 * j / (ny - 1); }  ///< of row j

  /// Line of sight of a point of the field of view, wearer frame, unit length.
  Eigen::Vector3d line_of_sight(double ndc_x, double ndc_y) const {
    return Eigen::Vector3d(ndc_x * tan_half_width, ndc_y * tan_half_height, -1.0).normalized();
  }

  /// 1/d of the k-th distance [D], k = 0 the nearest.
  double vergence(int k) const { return near_vergence_D + (far_vergence_D - near_vergence_D) * k / (nz - 1); }

  /// Place between the nodes, in steps of the grid.
  double column(double x) const { return 0.5 * (x + 1.0) * (nx - 1); }
  double row(double y) const { return 0.5 * (1.0 - y) * (ny - 1); }  ///< of ndc_y
  double slice(double vergence_D) const {
    return (near_vergence_D - vergence_D) / (near_vergence_D - far_vergence_D) * (nz - 1);
  }  ///< of a vergence [D]

  bool operator==(const FieldGrid&) const = default;  ///< every number is the same
};

}  // namespace sturm
