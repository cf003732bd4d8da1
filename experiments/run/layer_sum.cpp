#include "experiments/run/layer_sum.h"

#include <algorithm>
#include <functional>

#include "wavefront/layers/layer_blur.h"
#include "wavefront/layers/ray_kernels.h"

namespace sturm {

namespace {

/// The share of a vergence that a plane has.
float share_of(const KernelBank::Place& place, int plane) {
  if (plane == place.plane) return 1.0f - place.next_weight;
  return plane == place.plane + 1 ? place.next_weight : 0.0f;
}

/// The light of one plane, with nothing around it.
LayeredPicture layer_of(const LayeredPicture& picture, const KernelBank& bank, int plane) {
  LayeredPicture layer;
  layer.radiance = picture.radiance;
  layer.jump_D = picture.jump_D;
  layer.vergence_D.assign(picture.vergence_D.size(), bank.planes_D()[static_cast<std::size_t>(plane)]);
  for (std::size_t i = 0; i < picture.vergence_D.size(); ++i) {
    const float coverage = picture.coverage.empty() ? 1.0f : picture.coverage[i];
    const float weight = coverage * share_of(bank.place_of(picture.vergence_D[i]), plane);
    for (std::size_t c = 0; c < 3; ++c) layer.radiance.pixels[3 * i + c] *= weight;
  }
  return layer;
}

}  // namespace

Image sum_of_layers(const SurfacesPicture& surfaces, const Eye& eye, double pixel_slope,
                    const PredictionSpec& prediction) {
  const LayeredPicture& picture = surfaces.picture;
  const KernelModel model =
      ray_kernels(eye, eye.accommodation_for(0.0), pixel_slope / prediction.oversampling, {1, false});
  const KernelBank bank(model, planes_for(picture.vergence_D, model.reach_px_per_D));
  Image sum(picture.radiance.width, picture.radiance.height, 3);
  for (int plane = 0; plane < static_cast<int>(bank.planes_D().size()); ++plane) {
    const LayeredPicture layer = layer_of(picture, bank, plane);
    const auto lit = [](float value) { return value > 0.0f; };
    if (std::ranges::none_of(layer.radiance.pixels, lit)) continue;
    BlurCounters work;
    const KernelBank of_plane(model, {bank.planes_D()[static_cast<std::size_t>(plane)]});
    const Image blurred = blur_layers(layer, of_plane, work);
    std::ranges::transform(sum.pixels, blurred.pixels, sum.pixels.begin(), std::plus<>());
  }
  return without_margin(sum, surfaces.margin_px, prediction.oversampling);
}

}  // namespace sturm
