#include "wavefront/layers/wave_kernels.h"

#include <stdexcept>

#include "wavefront/layers/primaries.h"
#include "wavefront/layers/ray_kernels.h"
#include "wavefront/psf/wave_kernel.h"
#include "wavefront/psf/wave_sampling.h"

namespace sturm {

namespace {

constexpr double spectrum_step_nm = 20.0;
constexpr int coarse_grid = 512;  // pixels of pictures do not see what a finer one would add

SpreadKernel wave_kernel_at(const PupilWave& pupil, const Light& light, double vergence_D, double pixel_slope) {
  try {
    const WaveSampling sampling = wave_sampling(pupil, light, vergence_D, std::nullopt, coarse_grid);
    return wave_kernel(wave_psf(pupil, light, vergence_D, sampling), pixel_slope, largest_kernel_radius_px);
  } catch (const AliasedSampling& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace

KernelModel wave_kernels(const Eye& eye, double accommodation_D, double pixel_slope, bool chromatic) {
  if (!(pixel_slope > 0.0)) throw std::invalid_argument("a pixel has a size");
  const PupilWave pupil = PupilWave::of(eye, focus_wavelength_nm);
  KernelModel model;
  model.parts = {PupilPart{}};
  model.channels = chromatic ? 3 : 1;
  model.reach_px_per_D = eye.pupil_radius_m / pixel_slope;
  model.kernel = [=](double vergence_D, int, int channel) {
    const Light light = chromatic ? monochromatic_light(primary_wavelengths_nm[static_cast<std::size_t>(channel)])
                                  : luminance_weighted_light(spectrum_step_nm);
    return wave_kernel_at(pupil, light, vergence_D - accommodation_D, pixel_slope);
  };
  return model;
}

}  // namespace sturm
