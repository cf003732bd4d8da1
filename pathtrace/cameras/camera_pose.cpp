#include "pathtrace/cameras/camera_pose.h"

#include <Eigen/Geometry>
#include <cmath>

namespace sturm {

Eigen::Matrix3d head_axes(const CameraPose& pose) {
  const Eigen::Vector3d forward = (pose.look_at - pose.position).normalized(),
                        right = forward.cross(pose.up).normalized();
  Eigen::Matrix3d axes;
  axes << right, right.cross(forward), -forward;
  return axes;
}

double pixel_slope(const CameraPose& pose) {
  return 2.0 * std::tan(0.5 * pose.vertical_field) / pose.height;
}

CameraPose widened(const CameraPose& pose, int margin_px, int oversampling) {
  CameraPose wide = pose;
  wide.width = (pose.width + 2 * margin_px) * oversampling;
  wide.height = (pose.height + 2 * margin_px) * oversampling;
  wide.vertical_field = 2.0 * std::atan(0.5 * pixel_slope(pose) * (pose.height + 2 * margin_px));
  return wide;
}

}  // namespace sturm
