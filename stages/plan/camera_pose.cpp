#include "stages/plan/camera_pose.h"

#include <Eigen/Geometry>

namespace sturm {

CameraPose camera_pose(const CameraSpec& spec) {
  return {spec.position, spec.look_at, spec.up, spec.vfov, spec.width, spec.height};
}

CameraPose moved_sideways(const CameraPose& pose, double distance_m) {
  CameraPose moved = pose;
  const Eigen::Vector3d offset = distance_m * (pose.look_at - pose.position).cross(pose.up).normalized();
  moved.position += offset;
  moved.look_at += offset;
  return moved;
}

}  // namespace sturm
