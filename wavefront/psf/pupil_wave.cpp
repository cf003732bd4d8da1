#include "wavefront/psf/pupil_wave.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "lensmodel/zernike_order.h"

namespace sturm {

PupilWave PupilWave::of(const Eye& eye, double in_focus_nm) {
  if (!(eye.pupil_radius_m > 0.0)) throw std::invalid_argument("a pinhole has no point spread");
  return {eye.wavefront ? *eye.wavefront : ZernikeWave::of_power(eye.correction, eye.pupil_radius_m),
          eye.pupil_radius_m, eye.stiles_crawford_per_m2, in_focus_nm};
}

PupilWave PupilWave::mirrored() const {
  PupilWave other = *this;
  other.wave = ZernikeWave::from_examiner(wave.coefficients(), wave.radius_m());
  return other;
}

double PupilWave::intensity(double square_m2) const {
  return stiles_crawford_per_m2 == 0.0 ? 1.0 : std::exp(-std::numbers::ln10 * stiles_crawford_per_m2 * square_m2);
}

double PupilWave::area_m2() const {
  const double disc = std::numbers::pi * radius_m * radius_m;
  const double q = std::numbers::ln10 * stiles_crawford_per_m2 * radius_m * radius_m;
  return q == 0.0 ? disc : -disc * std::expm1(-q) / q;
}

double PupilWave::share_of(const PupilSector& sector) const {
  const double q = std::numbers::ln10 * stiles_crawford_per_m2 * radius_m * radius_m;
  const double within = q == 0.0 ? sector.outer - sector.inner
                                 : (std::exp(-q * sector.inner) - std::exp(-q * sector.outer)) / -std::expm1(-q);
  return within * (sector.to - sector.from);
}

double PupilWave::largest_slope(const Light& light, double vergence_D) const {
  constexpr int rings = 48, spokes = 192;
  constexpr double between_grid_points = 1.02;
  double lowest = vergence_D, highest = vergence_D;
  for (const SpectralLine& line : light) {
    lowest = std::min(lowest, vergence_at(line.wavelength_nm, vergence_D));
    highest = std::max(highest, vergence_at(line.wavelength_nm, vergence_D));
  }
  double largest = 0.0;
  for (int ring = 1; ring <= rings; ++ring)
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const double r = radius_m * ring / rings, angle = 2.0 * std::numbers::pi * spoke / spokes;
      const Eigen::Vector2d p(r * std::cos(angle), r * std::sin(angle));
      for (const double vergence : {lowest, highest})  // the slope is linear in it
        largest = std::max(largest, gradient(p, vergence).cwiseAbs().maxCoeff());
    }
  return between_grid_points * largest;
}

}  // namespace sturm
