#include "lensmodel/power_matrix.h"

#include <cmath>
#include <stdexcept>

#include "lensmodel/symmetric2.h"
#include "lensmodel/tabo.h"
#include "lensmodel/units.h"

namespace sturm {

PowerVector power_vector(const Prescription& rx) {
  const auto [sine, cosine] = sine_cosine_of_degrees(2.0 * rx.axis_deg);
  return {rx.spherical_equivalent_D(), -0.5 * rx.cylinder_D * cosine, -0.5 * rx.cylinder_D * sine};
}

PowerMatrix PowerMatrix::from(const Prescription& rx) {
  // AXIS α lies along the meridian 180° − α of the wearer; the power acts along u, 90° further.
  const auto [sine, cosine] = sine_cosine_of_degrees(180.0 - rx.axis_deg + 90.0);
  const double ux = cosine, uy = sine;
  const double S = rx.sphere_D, C = rx.cylinder_D;
  return from_components(S + C * ux * ux, C * ux * uy, S + C * uy * uy);
}

PowerMatrix PowerMatrix::from_components(double xx, double xy, double yy) {
  Eigen::Matrix2d m;
  m << xx, xy, xy, yy;
  return PowerMatrix(m);
}

PowerMatrix PowerMatrix::moved_towards_eye(double d) const {
  // F (I − dF)⁻¹ = (F − d·det F·I) / det(I − dF), symmetric by construction.
  const double det_f = difference_of_products(xx(), yy(), xy(), xy());
  const double det = difference_of_products(1.0 - d * xx(), 1.0 - d * yy(), d * xy(), d * xy());
  if (!(std::abs(det) > 1e-9))
    throw std::domain_error("the plane " + std::to_string(1e3 * d) +
                            " mm behind the lens lies at its focal line (I - dF is singular)");
  return from_components((xx() - d * det_f) / det, xy() / det, (yy() - d * det_f) / det);
}

Prescription PowerMatrix::as_prescription() const {
  const PrincipalValues p = principal_values(xx(), xy(), yy());
  if (p.isotropic) return {spherical_equivalent(), 0.0, 180.0, 0.0};
  // Minus-cylinder form: the AXIS lies along the meridian of the higher power (wearer frame, so 180° − angle).
  const double meridian_deg = line_direction_deg(std::atan2(p.high_direction.y(), p.high_direction.x()));
  return {p.high, p.low - p.high, tabo_deg(meridian_deg), 0.0};
}

PowerMatrix power_at_cornea(const Prescription& rx) {
  return PowerMatrix::from(rx).moved_towards_eye(rx.vertex_distance_m);
}

}  // namespace sturm
