#pragma once
#include <vector>

namespace sturm {

/// Wavelengths are stated in nanometres.
inline constexpr double metres_per_nanometre = 1e-9;

/// One wavelength of a light [nm], and its share of what is seen.
struct SpectralLine {
  double wavelength_nm, weight;  ///< > 0 [nm]; ≥ 0, a share where the weights of a light sum to 1
};

/// The light that a point spread is computed for; its weights sum to 1.
using Light = std::vector<SpectralLine>;

/// Shortest and longest wavelength that the chromatic eye and V(λ) are stated for [nm].
inline constexpr double shortest_visible_nm = 380.0, longest_visible_nm = 780.0;

/// The wavelength that the wavefront or prescription of whoever looks at a picture is taken to be in focus at [nm]: the
/// peak of daylight vision.
inline constexpr double focus_wavelength_nm = 555.0;

/// Vergence error [D] of the Indiana chromatic eye at a wavelength when it is in focus at another one:
/// 633.46·(1/(f − 214.102) − 1/(λ − 214.102)), wavelengths in nm [Thibos1992]. Negative for blue: the eye is myopic
/// there. It is *added* to the vergence of the target. Wavelengths > 300 nm.
double chromatic_vergence_D(double wavelength_nm, double in_focus_nm);

/// Luminous efficiency V(λ) of the CIE 1924 observer, linear between its values every 10 nm; 0 beyond 380 … 780 nm.
double luminous_efficiency(double wavelength_nm);

/// Light of equal energy at all wavelengths as the eye weights it: 400 nm, 400 nm + step … up to 700 nm, weights ∝
/// V(λ).
Light luminance_weighted_light(double step_nm);

/// One wavelength alone.
Light monochromatic_light(double wavelength_nm);

}  // namespace sturm
