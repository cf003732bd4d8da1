#include "lensmodel/prescription.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace sturm {

namespace {
void require_range(const char* what, double value, double low, double high) {
  if (!(value >= low && value <= high))
    throw std::invalid_argument(std::string(what) + " is " + std::to_string(value) + ", expected " + std::to_string(low) + " to " +
                                std::to_string(high));
}
}  // namespace

double folded_axis_deg(double axis_deg) {
  const double folded = std::fmod(axis_deg, 180.0);
  return folded <= 0.0 ? folded + 180.0 : folded;
}

Prescription transposed(const Prescription& rx) {
  return {rx.sphere_D + rx.cylinder_D, -rx.cylinder_D, folded_axis_deg(rx.axis_deg + 90.0), rx.vertex_distance_m};
}

Prescription in_minus_cylinder_form(const Prescription& rx) {
  if (rx.cylinder_D > 0.0) return transposed(rx);
  return {rx.sphere_D, rx.cylinder_D, rx.cylinder_D == 0.0 ? 180.0 : folded_axis_deg(rx.axis_deg), rx.vertex_distance_m};
}

void validate(const Prescription& rx) {
  require_range("sphere [D]", rx.sphere_D, -40.0, 40.0);
  require_range("cylinder [D]", rx.cylinder_D, -40.0, 40.0);
  require_range("axis [deg]", rx.axis_deg, 0.0, 180.0);
  require_range("vertex distance [m]", rx.vertex_distance_m, 0.0, 0.05);
}

}  // namespace sturm
