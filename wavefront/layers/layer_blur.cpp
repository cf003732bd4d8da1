#include "wavefront/layers/layer_blur.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>

#include "wavefront/layers/brightness.h"
#include "wavefront/layers/tile_blur.h"

namespace sturm {

long long BlurCounters::layers(LayerWork work) const {
  long long count = 0;
  for (const TileWork& tile : tiles) count += std::count(tile.layers.begin(), tile.layers.end(), work);
  return count;
}

float lamp_level(const Image& radiance) {
  return bright_level(radiance, 1000.0f);
}

Image blur_layers(const LayeredPicture& picture, const KernelBank& bank, BlurCounters& counters,
                  const std::function<void(double fraction)>& progress) {
  const int width = picture.radiance.width, height = picture.radiance.height;
  const std::size_t pixels = static_cast<std::size_t>(width) * height;
  if (pixels == 0 || picture.radiance.channels != 3 || picture.vergence_D.size() != pixels ||
      (!picture.coverage.empty() && picture.coverage.size() != pixels))
    throw std::invalid_argument("picture, vergence and coverage differ in size");
  const BlurPlan plan(bank);
  const KernelSpectra spectra(bank, plan);
  const LampKernels lamps(bank, picture.lamps);
  const BlurScene scene{picture, bank, plan, spectra, lamps, lamp_level(picture.radiance)};
  const int step = plan.side() - 2 * plan.rim(), columns = (width + step - 1) / step, rows = (height + step - 1) / step;
  Image seen(width, height, 3);
  counters.tiles.resize(static_cast<std::size_t>(columns) * rows);
  tbb::enumerable_thread_specific<TileBlur> blurs([&] { return TileBlur(scene); });
  std::atomic<int> done{0};
  tbb::parallel_for(0, columns * rows, [&](int tile) {
    TileWork& work = counters.tiles[static_cast<std::size_t>(tile)];
    work.left = (tile % columns) * step;
    work.top = (tile / columns) * step;
    blurs.local().blur(work, seen);
    if (progress) progress(static_cast<double>(++done) / (columns * rows));
  });
  for (const TileBlur& blur : blurs) counters.lamp_pixels += blur.lamp_pixels();
  counters.tile_side_px = plan.side();
  return seen;
}

}  // namespace sturm
