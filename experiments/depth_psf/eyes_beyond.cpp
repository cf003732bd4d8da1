#include <algorithm>
#include <cmath>

#include "experiments/depth_psf/depth_psf_study.h"
#include "lensmodel/units.h"
#include "wavefront/psf/ray_fan.h"

namespace sturm {

namespace {

constexpr std::size_t first_beyond = 6;  // OSA numbers below it are piston, tilt, defocus and astigmatism
constexpr std::size_t rays = 65536;
constexpr double in_focus_nm = 555.0;

double root_mean_square_um(const std::vector<double>& beyond_um) {
  double sum = 0.0;
  for (const double c : beyond_um) sum += c * c;
  return std::sqrt(sum);
}

/// The radius about their centroid that holds 80 % of the rays [arcmin].
double r80_arcmin(const std::vector<double>& beyond_um, double radius_m) {
  std::vector<double> coefficients_m;
  for (const double c : beyond_um) coefficients_m.push_back(1e-6 * c);
  const PupilWave pupil{ZernikeWave::from_examiner(coefficients_m, radius_m), radius_m, 0.0, in_focus_nm};
  const Light light = monochromatic_light(in_focus_nm);
  return arcminutes_per_radian *
         ray_radius(RayFan(pupil, light, rays), 0.0, ray_moments(pupil, light, 0.0).centroid, 0.8);
}

}  // namespace

EyesBeyond eyes_beyond(const MeasuredEyes& eyes, const ProgressFunction& progress) {
  const double radius_m = 0.5 * eyes.pupil_diameter_m;
  std::vector<double> rms_um, defocus_D, radii_arcmin;
  for (std::vector<double> coefficients_um : eyes.coefficients_um) {
    std::fill_n(coefficients_um.begin(), std::min(first_beyond, coefficients_um.size()), 0.0);
    rms_um.push_back(root_mean_square_um(coefficients_um));
    // A defocus M is the coefficient M r²/(4√3) of the normalised polynomial, whose root mean square is 1.
    defocus_D.push_back(4.0 * std::sqrt(3.0) * 1e-6 * rms_um.back() / (radius_m * radius_m));
    radii_arcmin.push_back(r80_arcmin(coefficients_um, radius_m));
    progress(static_cast<double>(rms_um.size()) / static_cast<double>(eyes.coefficients_um.size()));
  }
  const auto above = std::count_if(defocus_D.begin(), defocus_D.end(), [](double d) { return d > lens_step_D; });
  return {.id = eyes.id,
          .title = eyes.title,
          .pupil_mm = 1e3 * eyes.pupil_diameter_m,
          .eyes = static_cast<std::int64_t>(defocus_D.size()),
          .rms_um = quartiles_of(rms_um),
          .defocus_D = quartiles_of(defocus_D),
          .r80_arcmin = quartiles_of(radii_arcmin),
          .share_above_step = static_cast<double>(above) / static_cast<double>(defocus_D.size())};
}

}  // namespace sturm
