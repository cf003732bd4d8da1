#include "lensmodel/eye.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sturm {

double hofstetter_amplitude(double age_years) {
  return std::max(0.0, 18.5 - 0.3 * age_years);
}

Eye Eye::with(const Prescription& rx, double pupil_diameter_m, const Accommodation& accommodation) {
  validate(rx);
  if (!(pupil_diameter_m >= 0.0 && pupil_diameter_m <= 0.1))
    throw std::invalid_argument("pupil diameter is " + std::to_string(pupil_diameter_m) + " m, expected 0 to 0.1");
  Eye eye;
  eye.prescription = rx;
  eye.correction = power_at_cornea(rx);
  eye.pupil_radius_m = 0.5 * pupil_diameter_m;
  eye.accommodation = accommodation;
  return eye;
}

Eye Eye::with(const ZernikeWave& measured, SecondOrder rule, const std::optional<Prescription>& rx,
              double pupil_diameter_m, const Accommodation& accommodation) {
  Eye eye = with(rx.value_or(Prescription{}), pupil_diameter_m, accommodation);
  eye.wavefront = rx ? measured.plus(ZernikeWave::of_power(eye.correction, measured.radius_m())) : measured;
  const double a = eye.pupil_radius_m;  // the nearest parabola over a pinhole is the one at its centre
  eye.correction = a > 0.0 ? eye.wavefront->rescaled(a).power(rule) : eye.wavefront->power(SecondOrder::Paraxial);
  eye.prescription = eye.correction.as_prescription();
  return eye;
}

double Eye::accommodation_for(double target_vergence_D) const {
  if (const auto* fixed = std::get_if<FixedAccommodation>(&accommodation)) return fixed->power_D;
  if (const auto* best = std::get_if<BestAccommodation>(&accommodation))
    return std::clamp(target_vergence_D + correction.spherical_equivalent(), 0.0, best->amplitude_D);
  return 0.0;
}

std::optional<double> Eye::stated_focus_distance_m() const {
  return sturm::stated_focus_distance_m(accommodation);
}

}  // namespace sturm
