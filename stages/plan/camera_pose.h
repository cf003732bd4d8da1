#pragma once
#include "io/specs/camera_spec.h"
#include "pathtrace/cameras/camera_pose.h"

namespace sturm {

CameraPose camera_pose(const CameraSpec& spec);

/// The camera's pose, `distance_m` to the right.
CameraPose moved_sideways(const CameraPose& pose, double distance_m);

}  // namespace sturm
