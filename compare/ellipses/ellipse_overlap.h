#pragma once
#include <Eigen/Core>
#include <optional>

namespace sturm {

/// A filled ellipse: centre + map·(unit disc).
struct FilledEllipse {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  Eigen::Matrix2d map = Eigen::Matrix2d::Identity();  ///< any matrix; only map·mapᵀ matters

  /// The ellipse with these second moments: semi-axes 2·√eigenvalue.
  static FilledEllipse of_second_moments(const Eigen::Matrix2d& covariance,
                                         const Eigen::Vector2d& centre = Eigen::Vector2d::Zero());

  double area() const;  ///< π·|det map|
};

/// Area that two ellipses have in common. Exact up to rounding, about 1e-12 of the smaller area: one of them is made
/// the unit circle; the points where the other crosses it are the roots of a quartic on |z| = 1; between them the arcs
/// that bound the common part are integrated in closed form (Green). Where the ellipses touch, a root is known to √ε
/// only, and the area to ε^(3/2). Zero where either has no area.
double common_area(const FilledEllipse& a, const FilledEllipse& b);

/// Common area over that of the union, in [0, 1]; none where both have no area.
std::optional<double> intersection_over_union(const FilledEllipse& a, const FilledEllipse& b);

}  // namespace sturm
