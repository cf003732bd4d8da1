#include "pathtrace/film/progressive_render.h"

#include <tbb/parallel_for.h>

#include <mutex>
#include <vector>

#include "pathtrace/film/result_layers.h"
#include "pathtrace/film/tile_grid.h"

namespace sturm {

namespace {

constexpr int pass_tile_size = 16;

/// What all pixels hold between passes.
class Film {
 public:
  Film(int width, int height, bool guide)
      : width_(width), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    if (guide) guides_.resize(pixels_.size());
  }

  PixelRecords records(int x, int y) {
    const std::size_t i = index(x, y);
    return {pixels_[i].radiance, pixels_[i].first_hit, guides_.empty() ? nullptr : &guides_[i]};
  }
  const PixelStatistics& radiance(int x, int y) const { return pixels_[index(x, y)].radiance; }
  const FirstHitStatistics& first_hit(int x, int y) const { return pixels_[index(x, y)].first_hit; }
  GuideStatistics guide(int x, int y) const { return guides_.empty() ? GuideStatistics() : guides_[index(x, y)]; }

 private:
  struct Pixel {
    PixelStatistics radiance;
    FirstHitStatistics first_hit;
  };

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_;
  std::vector<Pixel> pixels_;
  std::vector<GuideStatistics> guides_;
};

}  // namespace

RenderResult render_in_passes(const PixelSource& source, const RenderSettings& settings) {
  const TileGrid tiles{source.width(), source.height(), pass_tile_size};
  const auto samples = static_cast<std::uint32_t>(settings.samples_per_pixel);
  Film film(tiles.width, tiles.height, settings.guide_layers);
  RenderResult result = empty_result(tiles.width, tiles.height, settings);
  std::mutex merging;
  const auto add_pass = [&](const SampleRange& range) {
    tbb::parallel_for(std::size_t{0}, tiles.count(), [&](std::size_t t) {
      const TileGrid::Tile tile = tiles.at(t);
      RenderCounters counters;
      for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) source.add_samples(x, y, range, film.records(x, y), counters);
      const std::lock_guard lock(merging);
      result.counters += counters;
    });
  };
  const auto picture = [&] {
    Image image(tiles.width, tiles.height, 3);
    for (int y = 0; y < tiles.height; ++y)
      for (int x = 0; x < tiles.width; ++x)
        for (int k = 0; k < 3; ++k) image.at(x, y)[k] = static_cast<float>(film.radiance(x, y).mean(k));
    return image;
  };
  PassSummary& summary = result.passes;
  std::uint32_t done = 0;
  for (summary.passes = 0; done < samples && !summary.interrupted; ++summary.passes) {
    const std::uint32_t count = std::min(samples_per_pass, samples - done);
    add_pass({0, done, count});
    done += count;
    const double fraction = static_cast<double>(done) / samples;
    if (settings.progress) settings.progress(fraction);
    if (settings.after_pass && done < samples) summary.interrupted = !settings.after_pass({fraction, picture});
  }
  for (int y = 0; y < tiles.height; ++y)
    for (int x = 0; x < tiles.width; ++x) {
      store_radiance(result, x, y, film.radiance(x, y));
      store_first_hit(result, x, y, film.first_hit(x, y), film.guide(x, y));
    }
  const auto pixels = static_cast<std::uint64_t>(tiles.width) * static_cast<std::uint64_t>(tiles.height);
  summary.samples_spent = summary.samples_kept = pixels * done;
  summary.samples_saved = pixels * (samples - done);
  return result;
}

}  // namespace sturm
