#include "conoid/tracing/footprint.h"

#include <cmath>

#include "lensmodel/units.h"

namespace sturm {

Footprint naked_eye_footprint(const Eye& eye, double distance_m, double accommodation_D) {
  const double vergence = vergence_of(distance_m);
  const PowerMatrix slope = eye.slope_matrix(accommodation_D);
  Footprint f;
  f.accommodation_D = accommodation_D;
  f.distance_m = distance_m;
  f.angular = (PowerMatrix::scalar(vergence) + slope).matrix();
  f.wavefront_curvature = Eigen::Matrix2d(-slope.matrix());
  return f;
}

Footprint naked_eye_footprint(const Eye& eye, double distance_m) {
  return naked_eye_footprint(eye, distance_m, eye.accommodation_for(vergence_of(distance_m)));
}

}  // namespace sturm
