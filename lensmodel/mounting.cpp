#include "lensmodel/mounting.h"

#include <Eigen/Geometry>

#include "lensmodel/gaze.h"

namespace sturm {

Mounting::Mounting(const Eigen::Vector2d& decentration_m, double pantoscopic_tilt, double wrap)
    : decentration_m_(decentration_m),
      pantoscopic_tilt_(pantoscopic_tilt),
      wrap_(wrap),
      straight_(decentration_m.isZero(0.0) && pantoscopic_tilt == 0.0 && wrap == 0.0) {
  // About x (to the right) and y (up) a positive angle would take the lower rim away from the wearer, and the right
  // one.
  wearer_from_lens_ = Eigen::AngleAxisd(-wrap, Eigen::Vector3d::UnitY()).toRotationMatrix() *
                      Eigen::AngleAxisd(-pantoscopic_tilt, Eigen::Vector3d::UnitX()).toRotationMatrix();
}

Mounting Mounting::with_wedge(const Eigen::Vector2d& slopes) const {
  Mounting result = *this;
  result.wedge_ = slopes;
  result.has_wedge_ = !slopes.isZero(0.0);
  result.lens_from_back_ =
      smallest_rotation({0.0, 0.0, -1.0}, Eigen::Vector3d(slopes.x(), slopes.y(), -1.0).normalized());
  return result;
}

}  // namespace sturm
