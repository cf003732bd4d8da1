#include "lensmodel/chromatic_eye.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace sturm {

namespace {

constexpr double table_step_nm = 10.0;

/// V(λ) at 380, 390 … 780 nm (CIE 1924).
constexpr std::array<double, 41> efficiency = {
    3.9e-05,  0.00012,  0.000396, 0.00121,  0.004,   0.0116, 0.023,   0.038,  0.06,  0.09098, 0.13902,
    0.20802,  0.323,    0.503,    0.71,     0.862,   0.954,  0.99495, 0.995,  0.952, 0.87,    0.757,
    0.631,    0.503,    0.381,    0.265,    0.175,   0.107,  0.061,   0.032,  0.017, 0.00821, 0.004102,
    0.002091, 0.001047, 0.00052,  0.000249, 0.00012, 6e-05,  3e-05,   1.5e-05};

}  // namespace

double chromatic_vergence_D(double wavelength_nm, double in_focus_nm) {
  constexpr double strength_D_nm = 633.46, pole_nm = 214.102;
  return strength_D_nm * (1.0 / (in_focus_nm - pole_nm) - 1.0 / (wavelength_nm - pole_nm));
}

double luminous_efficiency(double wavelength_nm) {
  if (!(wavelength_nm >= shortest_visible_nm && wavelength_nm <= longest_visible_nm)) return 0.0;
  const double place = (wavelength_nm - shortest_visible_nm) / table_step_nm;
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= efficiency.size()) return efficiency.back();
  return std::lerp(efficiency[below], efficiency[below + 1], place - static_cast<double>(below));
}

Light luminance_weighted_light(double step_nm) {
  constexpr double first_nm = 400.0, last_nm = 700.0;
  if (!(step_nm > 0.0)) throw std::invalid_argument("a spectrum needs a step > 0");
  Light light;
  double sum = 0.0;
  for (int i = 0; first_nm + i * step_nm <= last_nm * (1.0 + 1e-12); ++i) {
    light.push_back({first_nm + i * step_nm, luminous_efficiency(first_nm + i * step_nm)});
    sum += light.back().weight;
  }
  for (SpectralLine& line : light) line.weight /= sum;
  return light;
}

Light monochromatic_light(double wavelength_nm) {
  return {{wavelength_nm, 1.0}};
}

}  // namespace sturm
