#include "wavefront/psf/psf_kernels.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace sturm {

namespace {

SpreadKernel kernel_of(const PsfCells& cells, double scale) {
  const auto side = static_cast<int>(cells.energy.rows());
  SpreadKernel kernel;
  kernel.radius_px = side / 2;
  kernel.weights.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  for (int dy = -kernel.radius_px; dy <= kernel.radius_px; ++dy)
    for (int dx = -kernel.radius_px; dx <= kernel.radius_px; ++dx)  // the pupil's y points up, the picture's down
      kernel.weight(dx, dy) =
          static_cast<float>(scale * std::max(0.0, cells.energy(kernel.radius_px - dy, kernel.radius_px + dx)));
  return kernel;
}

}  // namespace

SpreadKernel ray_kernel(const RayFan& fan, double vergence_D, double pixel_rad) {
  double farthest = 0.0;
  fan.for_each(vergence_D,
               [&](const Eigen::Vector2d& x, double) { farthest = std::max(farthest, x.cwiseAbs().maxCoeff()); });
  const int radius = static_cast<int>(std::floor(farthest / pixel_rad + 0.5));
  return kernel_of(cells_of(fan, vergence_D, pixel_rad, 2 * radius + 1), 1.0);
}

SpreadKernel wave_kernel(const WavePsf& psf, double pixel_rad, double left_out) {
  const WaveEnergy energy(psf, Eigen::Vector2d::Zero());
  const double half_window = 0.5 * psf.sampling.window_rad();
  const double held = energy.within(half_window);
  const double reach = energy.radius((1.0 - left_out) * held).value_or(half_window);
  const int radius = static_cast<int>(std::ceil(std::min(reach, half_window) / pixel_rad));
  const PsfCells cells = cells_of(psf, pixel_rad, 2 * radius + 1);
  return kernel_of(cells, 1.0 / cells.energy.cwiseMax(0.0).sum());
}

std::vector<SpreadKernel> wave_kernels(const PupilWave& pupil, const Light& light,
                                       const std::vector<double>& vergences_D, double pixel_rad) {
  constexpr int coarse_grid = 512;
  std::vector<SpreadKernel> kernels(vergences_D.size());
  tbb::parallel_for(std::size_t{0}, kernels.size(), [&](std::size_t i) {
    const WaveSampling sampling = wave_sampling(pupil, light, vergences_D[i], std::nullopt, coarse_grid);
    kernels[i] = wave_kernel(wave_psf(pupil, light, vergences_D[i], sampling), pixel_rad);
  });
  return kernels;
}

}  // namespace sturm
