#pragma once
// Made-up pictures on pixels of one size, and what an eye sees of them.
#include <numeric>

#include "wavefront/layers/guessed_background.h"
#include "wavefront/layers/layer_blur.h"
#include "wavefront/layers/ray_kernels.h"

namespace sturm::testing {

inline constexpr double flat_pixel = 4e-4;  // tangent units

/// Everything at one vergence, and dark.
inline LayeredPicture flat_picture(int width, int height, double vergence_D) {
  LayeredPicture picture;
  picture.radiance = Image(width, height, 3);
  picture.vergence_D.assign(static_cast<std::size_t>(width) * height, vergence_D);
  return picture;
}

inline Eye astigmatic_myope(double pupil_mm) {
  return Eye::with(Prescription{-1.5, -1.0, 30.0, 0.0}, 1e-3 * pupil_mm);
}

/// By the planes of the picture; what is hidden is guessed beside what is given.
inline Image seen_through(const KernelModel& model, LayeredPicture picture) {
  picture.jump_D = 1.0 / model.reach_px_per_D;
  const KernelBank bank(model, planes_for(picture.vergence_D, model.reach_px_per_D));
  add_guessed_background(picture, bank);
  BlurCounters work;
  return blur_layers(picture, bank, work);
}

inline double light(const Image& image) {
  return std::accumulate(image.pixels.begin(), image.pixels.end(), 0.0);
}

}  // namespace sturm::testing
