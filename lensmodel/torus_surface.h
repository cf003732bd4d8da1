#pragma once
#include <optional>

#include "lensmodel/sag.h"

namespace sturm {

/// A torus: a circle (the generator), which stands in the meridian perpendicular to the sweep meridian, is swept about
/// an axis parallel to that perpendicular meridian. Either curvature may be 0: then it is a cylinder, or a plane.
class TorusSurface {
 public:
  /// Curvatures 1/R [1/m], R > 0 where the centre lies on the eye's side; `sweep_meridian_deg` in TABO degrees
  /// (examiner's frame).
  TorusSurface(double sweep_curvature, double generator_curvature, double sweep_meridian_deg);

  /// z(x, y); none beyond the generating circle or past the sweep axis.
  std::optional<Sag> sag(double x, double y) const;

  double sweep_curvature() const { return sweep_curvature_; }
  double generator_curvature() const { return generator_curvature_; }
  const Eigen::Vector2d& sweep_direction() const { return sweep_direction_; }  ///< unit vector, wearer frame

 private:
  double sweep_curvature_, generator_curvature_;
  Eigen::Vector2d sweep_direction_;
};

}  // namespace sturm
