#pragma once
#include <Eigen/Core>

#include "io/json.h"

namespace sturm {

/// Perspective camera in `camera` gaze (physics.md §3): the pupil's centre is `position`, the line of sight meets `look_at`.
struct CameraSpec {
  Eigen::Vector3d position{0.0, 0.0, 0.0};  ///< [m]
  Eigen::Vector3d look_at{0.0, 0.0, -1.0};  ///< [m], not at `position`
  Eigen::Vector3d up{0.0, 1.0, 0.0};        ///< any length; not parallel to the line of sight
  double vfov = 0.0;                        ///< full vertical field of view [rad], in (0, π)
  int width = 0, height = 0;                ///< [px]
};

/// Reads a "camera" object. Throws InputError.
CameraSpec read_camera(const Json& value, const Source& where);

}  // namespace sturm
