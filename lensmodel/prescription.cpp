#include "lensmodel/prescription.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace sturm {

namespace {
/// As few digits, from six on, as tell the number from its neighbours, and so from a bound that it passes.
std::string shortest(double value) {
  char text[32];
  for (int digits = 6; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  return text;
}

void require_range(const char* what, double value, double low, double high) {
  if (!(value >= low && value <= high))
    throw std::invalid_argument(std::string(what) + " is " + shortest(value) + ", expected " + shortest(low) + " to " +
                                shortest(high));
}
}  // namespace

double folded_axis_deg(double axis_deg) {
  const double folded = std::fmod(axis_deg, 180.0);
  return folded <= 0.0 ? folded + 180.0 : folded;
}

Prescription transposed(const Prescription& rx) {
  Prescription result = rx;
  result.sphere_D = rx.sphere_D + rx.cylinder_D;
  result.cylinder_D = -rx.cylinder_D;
  result.axis_deg = folded_axis_deg(rx.axis_deg + 90.0);
  return result;
}

Prescription in_minus_cylinder_form(const Prescription& rx) {
  if (rx.cylinder_D > 0.0) return transposed(rx);
  Prescription result = rx;
  result.axis_deg = rx.cylinder_D == 0.0 ? 180.0 : folded_axis_deg(rx.axis_deg);
  return result;
}

void validate(const Prescription& rx) {
  require_range("sphere [D]", rx.sphere_D, -40.0, 40.0);
  require_range("cylinder [D]", rx.cylinder_D, -40.0, 40.0);
  require_range("axis [deg]", rx.axis_deg, 0.0, 180.0);
  require_range("vertex distance [m]", rx.vertex_distance_m, 0.0, 0.05);
  require_range("prism [cm/m]", rx.prism_cm_per_m, 0.0, 40.0);
  require_range("base of the prism [deg]", rx.prism_base_deg, 0.0, 360.0);
}

}  // namespace sturm
