#include "conoid/tracing/turned_eye.h"

#include "lensmodel/gaze.h"
#include "lensmodel/units.h"

namespace sturm {

TurnedEye::TurnedEye(const Eye& eye, const Spectacles* lens, const Eigen::Vector3d& gaze)
    : eye_(eye), line_of_sight_{turned_pupil_center(gaze, eye.rotation_center_m), gaze} {
  if (lens) conoid_ = trace_conoid(*lens, gaze, eye.rotation_center_m);
}

double TurnedEye::accommodation(double vergence_D) const {
  return conoid_ ? accommodation_through(*conoid_, eye_, vergence_D) : eye_.accommodation_for(vergence_D);
}

Footprint TurnedEye::footprint(double distance_m, double accommodation_D) const {
  return conoid_ ? spectacle_footprint(*conoid_, eye_, distance_m, accommodation_D)
                 : naked_eye_footprint(eye_, distance_m, accommodation_D);
}

Footprint TurnedEye::footprint(double distance_m) const {
  return footprint(distance_m, accommodation(vergence_of(distance_m)));
}

}  // namespace sturm
