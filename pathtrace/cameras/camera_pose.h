#pragma once
#include <Eigen/Core>

namespace sturm {

/// Where the eye is and where it looks; perspective, `camera` gaze (docs/theory.md#32-gaze-models).
struct CameraPose {
  Eigen::Vector3d position{0.0, 0.0, 0.0};  ///< centre of the pupil [m], world
  Eigen::Vector3d look_at{0.0, 0.0, -1.0};  ///< [m], world
  Eigen::Vector3d up{0.0, 1.0, 0.0};
  double vertical_field = 0.6860;  ///< [rad]
  int width = 256, height = 256;   ///< [px]
};

/// Axes right, up and back of the pose as columns: takes the wearer frame to the world's.
Eigen::Matrix3d head_axes(const CameraPose& pose);

/// Pixel pitch in tangent image coordinates [rad].
double pixel_slope(const CameraPose& pose);

/// The same view with `margin_px` more pixels on every side, same pixel pitch; then each pixel divided into
/// oversampling² pixels.
CameraPose widened(const CameraPose& pose, int margin_px, int oversampling);

}  // namespace sturm
