#include "wavefront/psf/wave_kernel.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "io/files/formatted_text.h"

namespace sturm {

SpreadKernel wave_kernel(const WavePsf& psf, double pixel_rad, int largest_radius_px, double left_out) {
  const WaveEnergy energy(psf, Eigen::Vector2d::Zero());
  const double half_window = 0.5 * psf.sampling.window_rad();
  const double held = energy.within(half_window);
  const double reach = energy.radius((1.0 - left_out) * held).value_or(half_window);
  const double needed_px = std::ceil(std::min(reach, half_window) / pixel_rad);
  if (!(needed_px <= largest_radius_px))
    throw std::invalid_argument("the blur reaches " + plain_number(needed_px) + " pixels, more than " +
                                std::to_string(largest_radius_px));
  const int radius = static_cast<int>(needed_px);
  const PsfCells cells = cells_of(psf, pixel_rad, 2 * radius + 1);
  const double scale = 1.0 / cells.energy.cwiseMax(0.0).sum();
  SpreadKernel kernel;
  kernel.radius_px = radius;
  kernel.widening_px2 = 1.0 / 12.0;  // of a pixel's width
  kernel.weights.resize(static_cast<std::size_t>(kernel.side()) * static_cast<std::size_t>(kernel.side()));
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx)  // the pupil's y points up, the picture's down
      kernel.weight(dx, dy) = static_cast<float>(scale * std::max(0.0, cells.energy(radius - dy, radius + dx)));
  return kernel;
}

}  // namespace sturm
