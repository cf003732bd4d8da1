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

/// Where a direction meets the picture plane z = −1: tangents to the right and up. Its z must be < 0.
Eigen::Vector2d picture_point(const Eigen::Vector3d& direction);

/// Takes small angles on (e1, e2) across `direction` (unit vector, z < 0) to offsets on the picture plane: sec² of the
/// field angle along the radius, sec across it (docs/theory.md#81-sights-any-gaze-spectacles).
Eigen::Matrix2d picture_jacobian(const Eigen::Vector3d& direction, const Eigen::Vector3d& e1,
                                 const Eigen::Vector3d& e2);

}  // namespace sturm
