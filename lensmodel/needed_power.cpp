#include "lensmodel/needed_power.h"

namespace sturm {

Prescription needed_power(const Eye& eye, double vertex_distance_m) {
  if (eye.prescription.vertex_distance_m == vertex_distance_m) return eye.prescription;
  Prescription moved = eye.correction.moved_towards_eye(-vertex_distance_m).as_prescription();
  moved.prism_cm_per_m = eye.prescription.prism_cm_per_m;
  moved.prism_base_deg = eye.prescription.prism_base_deg;
  return moved;
}

}  // namespace sturm
