#include "lensmodel/single_vision.h"

#include <cmath>
#include <stdexcept>

#include "lensmodel/prism.h"

namespace sturm {

namespace {

/// The front surface's power carried through the glass to the back vertex [D].
double carried_to_back(double front_power_D, double thickness_m, double index) {
  const double denominator = 1.0 - thickness_m / index * front_power_D;
  if (!(std::abs(denominator) > 1e-9))
    throw std::domain_error("the focus of the lens's front surface lies in its back vertex");
  return front_power_D / denominator;
}

}  // namespace

double usual_base_curve_D(const Prescription& rx) {
  const double mean = rx.sphere_D + 0.5 * rx.cylinder_D;
  return std::fmax(0.0, mean < 0.0 ? 0.5 * mean + 6.0 : mean + 6.0);
}

double back_vertex_power(double front_power_D, double back_power_D, double thickness_m, double refractive_index) {
  return back_power_D + carried_to_back(front_power_D, thickness_m, refractive_index);
}

Spectacles single_vision(const Prescription& rx, const SingleVisionDesign& design) {
  const double excess = design.refractive_index - 1.0;
  if (!(excess > 0.0))
    throw std::invalid_argument("a refractive index of " + std::to_string(design.refractive_index) + " makes no lens");
  const Prescription minus = in_minus_cylinder_form(rx);
  const double base_curve_D = design.base_curve_D.value_or(usual_base_curve_D(rx));
  const double carried = carried_to_back(base_curve_D, design.center_thickness_m, design.refractive_index);
  // Light from outside meets the front as +F = (n − 1)/R and the back as −(n − 1)/R, R > 0 towards the eye.
  const auto back_curvature = [&](double power_D) { return (carried - power_D) / excess; };
  Spectacles lens;
  lens.front = SphereSurface{base_curve_D / excess};
  if (minus.cylinder_D == 0.0)
    lens.back = SphereSurface{back_curvature(minus.sphere_D)};
  else
    lens.back =
        TorusSurface(back_curvature(minus.sphere_D), back_curvature(minus.sphere_D + minus.cylinder_D), minus.axis_deg);
  lens.center_thickness_m = design.center_thickness_m;
  lens.refractive_index = design.refractive_index;
  lens.vertex_distance_m = design.vertex_distance_m;
  lens.diameter_m = design.diameter_m;
  lens.mounting = design.mounting;
  return rx.prism_cm_per_m == 0.0 ? lens : with_prism(lens, rx.prism_cm_per_m, rx.prism_base_deg);
}

}  // namespace sturm
