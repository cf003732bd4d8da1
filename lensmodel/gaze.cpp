#include "lensmodel/gaze.h"

#include <Eigen/Geometry>
#include <cmath>

namespace sturm {

Eigen::Vector3d gaze_direction(double azimuth, double elevation) {
  return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), -std::cos(azimuth) * std::cos(elevation)};
}

Eigen::Matrix3d smallest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  // R = I + [v]× + [v]×² / (1 + c), with v = from × to and c = from · to.
  const Eigen::Vector3d v = from.cross(to);
  Eigen::Matrix3d cross;
  cross << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return Eigen::Matrix3d::Identity() + cross + cross * cross / (1.0 + from.dot(to));
}

Eigen::Vector3d turned_pupil_center(const Eigen::Vector3d& direction, double rotation_center_m) {
  return rotation_center_m * (direction + Eigen::Vector3d(0.0, 0.0, 1.0));
}

Eigen::Vector2d picture_point(const Eigen::Vector3d& direction) {
  return direction.head<2>() / -direction.z();
}

Eigen::Matrix2d picture_jacobian(const Eigen::Vector3d& direction, const Eigen::Vector3d& e1,
                                 const Eigen::Vector3d& e2) {
  const auto moved = [&](const Eigen::Vector3d& e) -> Eigen::Vector2d {
    return (e.head<2>() + picture_point(direction) * e.z()) / -direction.z();
  };
  Eigen::Matrix2d jacobian;
  jacobian << moved(e1), moved(e2);
  return jacobian;
}

}  // namespace sturm
