#pragma once
#include <Eigen/Core>

namespace sturm {

/// Direction of the line of sight for azimuth to the wearer's right and elevation up [rad]:
/// (sin az cos el, sin el, −cos az cos el), wearer frame.
Eigen::Vector3d gaze_direction(double azimuth, double elevation);

/// Smallest rotation that takes `from` to `to` (unit vectors, not opposite). Listing's law for from = −z.
Eigen::Matrix3d smallest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Centre of the pupil after the eye has turned to `direction` [m], origin at the pupil centre in primary gaze.
Eigen::Vector3d turned_pupil_center(const Eigen::Vector3d& direction, double rotation_center_m);

}  // namespace sturm
