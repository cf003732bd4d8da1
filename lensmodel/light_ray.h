#pragma once
#include <Eigen/Core>

namespace sturm {

/// Half a line: origin [m] and unit direction, wearer frame unless told otherwise.
struct LightRay {
  Eigen::Vector3d origin, direction;  ///< [m]; unit vector

  Eigen::Vector3d at(double distance) const { return origin + distance * direction; }  ///< [m]
};

}  // namespace sturm
