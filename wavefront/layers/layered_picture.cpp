#include "wavefront/layers/layered_picture.h"

#include <algorithm>
#include <cmath>

#include "io/images/depth_edges.h"
#include "wavefront/layers/layer_detail.h"

namespace sturm {

std::vector<std::size_t> edges_of(const LayeredPicture& picture) {
  return depth_edges(picture.vergence_D, picture.radiance.width, picture.radiance.height, picture.jump_D);
}

SurfaceSlope surface_slope(const std::vector<double>& vergence_D, int width, int height, int x, int y, double jump_D) {
  const auto at = [&](int u, int v) { return vergence_D[static_cast<std::size_t>(v) * width + u]; };
  const double here = at(x, y);
  const auto along = [&](bool has_before, double before, bool has_after, double after) {
    has_before = has_before && std::abs(here - before) <= jump_D;
    has_after = has_after && std::abs(after - here) <= jump_D;
    if (has_before && has_after) return 0.5 * (after - before);
    return has_before ? here - before : has_after ? after - here : 0.0;
  };
  const bool left = x > 0, right = x + 1 < width, up = y > 0, down = y + 1 < height;
  return {static_cast<float>(along(left, left ? at(x - 1, y) : 0.0, right, right ? at(x + 1, y) : 0.0)),
          static_cast<float>(along(up, up ? at(x, y - 1) : 0.0, down, down ? at(x, y + 1) : 0.0))};
}

bool lies_before(const PictureLayer& layer, const LayeredPicture& picture, std::size_t pixel) {
  return !layer.coverage.empty() && layer.coverage[pixel] > 0.0f && layer.coverage[pixel] < covers_all &&
         layer.vergence_D[pixel] > picture.vergence_D[pixel] + picture.jump_D;
}

std::vector<HiddenPixel> hidden_by(const LayeredPicture& picture, std::span<const PictureLayer> layers) {
  const int width = picture.radiance.width, height = picture.radiance.height;
  std::vector<HiddenPixel> hidden;
  std::vector<LayerDetail> details;
  for (const PictureLayer& layer : layers)
    details.emplace_back(layer.radiance, layer.vergence_D, layer.coverage, picture.jump_D);
  std::vector<std::span<const Detail>> rows(layers.size());
  for (int y = 0; y < height; ++y) {
    std::ranges::transform(details, rows.begin(), &LayerDetail::next_row);
    for (int x = 0; x < width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * width + x;
      const bool see_through = !picture.coverage.empty() && picture.coverage[i] < 1.0f;
      for (std::size_t number = 0; number < layers.size(); ++number) {
        const PictureLayer& layer = layers[number];
        const float coverage = layer.coverage.empty() ? 1.0f : layer.coverage[i];
        const double vergence = layer.vergence_D[i];
        const bool behind = vergence < picture.vergence_D[i] - picture.jump_D;
        if (!(coverage > 0.0f) || !(see_through || behind || lies_before(layer, picture, i))) continue;
        const float* rgb = layer.radiance.at(x, y);
        const SurfaceSlope slope = surface_slope(layer.vergence_D, width, height, x, y, picture.jump_D);
        const Detail& detail = rows[number][static_cast<std::size_t>(x)];
        hidden.push_back({x, y, vergence, coverage, {rgb[0], rgb[1], rgb[2]}, slope.x, slope.y, detail});
      }
    }
  }
  return hidden;
}

}  // namespace sturm
