#include "wavefront/psf/wave_sampling.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "lensmodel/units.h"
#include "wavefront/psf/transform.h"

namespace sturm {

namespace {

/// The window leaves a tenth beyond the farthest ray, and on either side so many λ/D for the rings about it.
constexpr double slope_room = 1.1, rings_room = 12.0;
constexpr int rim_cells = 4;  // of the pupil, which stick out of its disc

std::string whole(double number) {
  return std::to_string(static_cast<long long>(std::ceil(number)));
}

std::string rounded(double number) {
  std::string text = std::to_string(number);
  return text.substr(0, text.find('.') + 2);
}

}  // namespace

WaveSampling wave_sampling(const PupilWave& pupil, const Light& light, double vergence_D, std::optional<int> grid,
                           int least) {
  double shortest = light.front().wavelength_nm, longest = shortest;
  for (const SpectralLine& line : light) {
    shortest = std::min(shortest, line.wavelength_nm);
    longest = std::max(longest, line.wavelength_nm);
  }
  const double diameter = 2.0 * pupil.radius_m;
  const double slope = pupil.largest_slope(light, vergence_D);
  const double window = 2.0 * (slope_room * slope + rings_room * metres_per_nanometre * longest / diameter);
  const double cutoff = diameter / (metres_per_nanometre * shortest);
  const double needed = 2.0 * cutoff * window + rim_cells;
  const double most = grid ? *grid : largest_wave_grid;
  if (needed > most)
    throw AliasedSampling("slopes of " + rounded(slope * arcminutes_per_radian) + " arcmin over a pupil of " +
                          rounded(diameter / metres_per_millimetre) + " mm need a grid of " + whole(needed) +
                          " samples at " + whole(shortest) + " nm; a grid of " + whole(most) + " would alias");
  const int size =
      grid ? *grid : std::min(quick_size(std::max(least, static_cast<int>(std::ceil(needed)))), largest_wave_grid);
  return {size, 2.0 * cutoff / (size - rim_cells)};
}

}  // namespace sturm
