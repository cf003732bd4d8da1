#pragma once
#include <optional>
#include <stdexcept>

#include "wavefront/psf/pupil_wave.h"

namespace sturm {

/// The grid that a wave's point spread is computed on: grid × grid samples over a window of 1/frequency_step [rad].
struct WaveSampling {
  int grid;               ///< samples along each side
  double frequency_step;  ///< [cycles/rad]; a wavelength λ samples the pupil every λ·frequency_step

  double window_rad() const { return 1.0 / frequency_step; }          ///< side of the window
  double pixel_rad() const { return 1.0 / (grid * frequency_step); }  ///< side of a sample
};

/// The grid that was asked for, or that is allowed at all, would alias: light would come back in at the other side of
/// the window. The message says which grid would do.
class AliasedSampling : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline constexpr int least_wave_grid = 1024, largest_wave_grid = 4096;  ///< samples along each side

/// The sampling that the wave's largest slope asks for: neighbouring samples of the pupil differ by less than half a
/// wave, with room for the light that the rim diffracts, and the highest frequency 2a/λ stays below the grid's. `grid`
/// fixes the size; otherwise it is `least` or more. Throws AliasedSampling.
WaveSampling wave_sampling(const PupilWave& pupil, const Light& light, double vergence_D,
                           std::optional<int> grid = std::nullopt, int least = least_wave_grid);

}  // namespace sturm
