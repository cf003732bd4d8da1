#pragma once
#include <Eigen/Core>
#include <optional>

namespace sturm {

/// An ellipse centred on the chief ray: image of the pupil disc, or the one with the same second moments as a ray
/// bundle.
struct Ellipse {
  double semi_major = 0.0;                ///< ≥ semi_minor; [m] or [rad] as its source says
  double semi_minor = 0.0;                ///< ≥ 0
  std::optional<double> orientation_deg;  ///< of the major axis, wearer frame, (−90, 90]; none for a circle

  /// Image of the disc of radius `radius` under `map`.
  static Ellipse image_of_disc(const Eigen::Matrix2d& map, double radius);

  /// With semi-axes 2·√eigenvalue of a covariance matrix [[xx, xy], [xy, yy]] (exact for a uniform ellipse).
  static Ellipse of_second_moments(const Eigen::Matrix2d& covariance);
};

/// Covariance of a uniform disc of radius `radius` mapped by `map`: radius²/4 · map mapᵀ.
Eigen::Matrix2d covariance_of_disc_image(const Eigen::Matrix2d& map, double radius);

}  // namespace sturm
