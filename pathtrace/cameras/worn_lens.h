#pragma once
#include <Eigen/Core>

#include "lensmodel/gaze.h"
#include "lensmodel/spectacles.h"
#include "pathtrace/cameras/ray_model.h"

namespace sturm {

/// A spectacle lens before an eye that has turned about its centre of rotation: whatever model the rays leave the eye
/// by, from there on they go through both surfaces by Snell's law (docs/theory.md#114-real-rays).
class WornLens {
 public:
  /// `gaze`: unit vector of the line of sight, wearer frame.
  WornLens(const Spectacles& lens, const Eigen::Vector3d& gaze, double rotation_center_m)
      : lens_(lens),
        pupil_center_(turned_pupil_center(gaze, rotation_center_m)),
        turn_(smallest_rotation({0.0, 0.0, -1.0}, gaze)) {}

  /// The way of a ray that leaves the turned pupil (offset and slope on its axes) through the lens.
  LensPath path_of(const PupilRay<double>& ray) const {
    return trace(lens_, {pupil_center_ + turn_ * Eigen::Vector3d(ray.px, ray.py, 0.0),
                         (turn_ * Eigen::Vector3d(ray.sx, ray.sy, -1.0)).normalized()});
  }

  LensPath chief_ray() const { return path_of({0.0, 0.0, 0.0, 0.0, LaunchStatus::ok}); }

 private:
  Spectacles lens_;
  Eigen::Vector3d pupil_center_;
  Eigen::Matrix3d turn_;
};

}  // namespace sturm
