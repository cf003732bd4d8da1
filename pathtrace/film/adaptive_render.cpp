#include "pathtrace/film/adaptive_render.h"

#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <mutex>
#include <vector>

#include "pathtrace/film/progressive_render.h"
#include "pathtrace/film/result_layers.h"
#include "pathtrace/film/sample_planner.h"
#include "pathtrace/film/tile_error.h"
#include "pathtrace/film/tile_grid.h"

namespace sturm {

namespace {

constexpr int streams = 4;
using Color = std::array<double, 3>;

/// What a pixel holds between passes. Half h is the streams 2h and 2h + 1, which always have the same number of
/// samples.
struct Pixel {
  std::array<PixelStatistics, streams> stream;
  FirstHitStatistics first_hit;
  std::array<Color, 2> kept{};  ///< what the halves are kept at, once that is decided

  Color half(int h) const {
    Color mean;
    for (int k = 0; k < 3; ++k)
      mean[static_cast<std::size_t>(k)] =
          0.5 * (stream[static_cast<std::size_t>(2 * h)].mean(k) + stream[static_cast<std::size_t>(2 * h + 1)].mean(k));
    return mean;
  }
};

Color stream_mean(const PixelStatistics& stream) {
  return {stream.mean(0), stream.mean(1), stream.mean(2)};
}

class ErrorRenderer {
 public:
  ErrorRenderer(const PixelSource& source, const RenderSettings& settings)
      : source_(source),
        settings_(settings),
        tiles_{source.width(), source.height(), settings.adaptive.value_or(AdaptiveSpec()).tile_px},
        limit_(static_cast<std::uint32_t>(settings.samples_per_pixel) / streams),
        pixels_(static_cast<std::size_t>(tiles_.width) * static_cast<std::size_t>(tiles_.height)),
        kept_samples_(tiles_.count()),
        result_(empty_result(tiles_.width, tiles_.height, settings)) {
    if (settings.guide_layers) guides_.resize(pixels_.size());
    std::vector<int> sizes;
    for (std::size_t t = 0; t < tiles_.count(); ++t) sizes.push_back(tiles_.at(t).pixels());
    planners_.assign(2, SamplePlanner(sizes, *settings.relative_error,
                                      settings.adaptive.has_value() && settings.end_converged_tiles));
  }

  RenderResult run() {
    result_.passes.passes = 0;
    std::uint32_t next =
        static_cast<std::uint32_t>(settings_.adaptive.value_or(AdaptiveSpec()).min_samples_per_pixel) / streams;
    for (;; next = 2 * done_) {
      const std::vector<std::size_t> active = active_tiles();
      if (active.empty() || done_ == limit_ || result_.passes.interrupted) break;
      advance(active, std::min(next, limit_));
      measure(active);
      decide(active);
    }
    store();
    if (settings_.progress) settings_.progress(1.0);
    return std::move(result_);
  }

 private:
  Pixel& pixel(int x, int y) { return pixels_[index(x, y)]; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(tiles_.width) + static_cast<std::size_t>(x);
  }

  /// Whether half `h` of a tile is still growing: the other half's planner says so.
  bool grows(int h, std::size_t tile) const { return planners_[static_cast<std::size_t>(1 - h)].wants(tile); }

  std::vector<std::size_t> active_tiles() const {
    std::vector<std::size_t> active;
    for (std::size_t t = 0; t < tiles_.count(); ++t)
      if (grows(0, t) || grows(1, t)) active.push_back(t);
    return active;
  }

  template <class Function>
  void for_each_pixel(std::size_t tile_index, const Function& function) const {
    const TileGrid::Tile tile = tiles_.at(tile_index);
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) function(x, y);
  }

  /// Takes every stream of the active tiles to `samples` samples, in parts between which the caller may end it.
  void advance(const std::vector<std::size_t>& active, std::uint32_t samples) {
    while (done_ < samples && !result_.passes.interrupted) {
      const std::uint32_t count = std::min(samples_per_pass, samples - done_);
      add_samples(active, count);
      done_ += count;
      ++result_.passes.passes;
      const double fraction =
          static_cast<double>(result_.passes.samples_spent) / (static_cast<double>(pixels_.size()) * streams * limit_);
      if (settings_.progress) settings_.progress(std::min(fraction, 0.99));  // where it ends is not known
      if (settings_.after_pass && done_ < limit_)
        result_.passes.interrupted = !settings_.after_pass({fraction, [this] { return picture_so_far(); }});
    }
  }

  void add_samples(const std::vector<std::size_t>& active, std::uint32_t count) {
    std::mutex merging;
    tbb::parallel_for(std::size_t{0}, active.size(), [&](std::size_t i) {
      RenderCounters counters;
      for_each_pixel(active[i], [&](int x, int y) {
        Pixel& p = pixel(x, y);
        GuideStatistics* const guide = guides_.empty() ? nullptr : &guides_[index(x, y)];
        for (int s = 0; s < streams; ++s)
          source_.add_samples(x, y, {s, done_, count}, {p.stream[static_cast<std::size_t>(s)], p.first_hit, guide},
                              counters);
      });
      const std::lock_guard lock(merging);
      result_.counters += counters;
    });
    for (const std::size_t t : active)
      result_.passes.samples_spent += static_cast<std::uint64_t>(tiles_.at(t).pixels()) * streams * count;
  }

  void measure(const std::vector<std::size_t>& active) {
    tbb::parallel_for(std::size_t{0}, active.size(), [&](std::size_t i) {
      const std::size_t t = active[i];
      for (std::size_t h : {0, 1}) {
        if (!planners_[h].wants(t)) continue;
        std::vector<PixelPair> pairs;
        for_each_pixel(t, [&](int x, int y) {
          const auto& stream = pixel(x, y).stream;
          pairs.push_back({stream_mean(stream[2 * h]), stream_mean(stream[2 * h + 1])});
        });
        // The picture has both halves, and so half the variance of one.
        planners_[h].measured(t, streams * done_, 0.5 * tile_squared_error(pairs, tiles_.at(t).x1 - tiles_.at(t).x0));
      }
    });
  }

  /// Lets both planners decide and keeps the halves that have come to their end.
  void decide(const std::vector<std::size_t>& active) {
    std::vector<std::array<bool, 2>> grew;
    for (const std::size_t t : active) grew.push_back({grows(0, t), grows(1, t)});
    for (SamplePlanner& planner : planners_) planner.decide();
    const bool end = done_ == limit_ || result_.passes.interrupted;
    for (std::size_t i = 0; i < active.size(); ++i) {
      const std::size_t t = active[i];
      for (int h : {0, 1})
        if (grew[i][static_cast<std::size_t>(h)] && (end || !grows(h, t))) keep(h, t);
      result_.passes.tiles_converged += !grows(0, t) && !grows(1, t);
    }
  }

  void keep(int h, std::size_t tile) {
    const auto slot = static_cast<std::size_t>(h);
    for_each_pixel(tile, [&](int x, int y) { pixel(x, y).kept[slot] = pixel(x, y).half(h); });
    kept_samples_[tile][slot] = streams / 2 * done_;
  }

  Image picture_so_far() {
    Image image(tiles_.width, tiles_.height, 3);
    for (std::size_t t = 0; t < tiles_.count(); ++t)
      for_each_pixel(t, [&](int x, int y) {
        const Pixel& p = pixel(x, y);
        const Color a = grows(0, t) ? p.half(0) : p.kept[0], b = grows(1, t) ? p.half(1) : p.kept[1];
        for (std::size_t k = 0; k < 3; ++k) image.at(x, y)[k] = static_cast<float>(0.5 * (a[k] + b[k]));
      });
    return image;
  }

  void store() {
    PassSummary& summary = result_.passes;
    summary.tiles = tiles_.count();
    summary.samples_of_longest = pixels_.size() * std::uint64_t{streams} * done_;
    double error = 0.0;
    for (std::size_t t = 0; t < tiles_.count(); ++t) {
      const std::uint32_t samples = kept_samples_[t][0] + kept_samples_[t][1];
      const auto count = static_cast<std::uint64_t>(tiles_.at(t).pixels());
      summary.samples_kept += count * samples;
      std::vector<PixelPair> pairs;
      for_each_pixel(t, [&](int x, int y) {
        const Pixel& p = pixel(x, y);
        store_pixel(x, y, p, samples);
        pairs.push_back({p.kept[0], p.kept[1]});
      });
      error += static_cast<double>(count) * tile_squared_error(pairs, tiles_.at(t).x1 - tiles_.at(t).x0);
    }
    summary.samples_saved =
        pixels_.size() * static_cast<std::uint64_t>(settings_.samples_per_pixel) - summary.samples_spent;
    summary.measured_relative_error = std::sqrt(error / static_cast<double>(pixels_.size()));
  }

  void store_pixel(int x, int y, const Pixel& p, std::uint32_t samples) {
    PixelStatistics all;
    for (const PixelStatistics& stream : p.stream) all.merge(stream);
    store_radiance(result_, x, y, all);  // the variance of single samples; the mean comes from what is kept
    for (std::size_t k = 0; k < 3; ++k) {
      const double half_difference = 0.5 * (p.kept[0][k] - p.kept[1][k]);
      result_.radiance.at(x, y)[k] = static_cast<float>(0.5 * (p.kept[0][k] + p.kept[1][k]));
      result_.mean_variance.at(x, y)[k] = static_cast<float>(half_difference * half_difference);
    }
    *result_.samples.at(x, y) = static_cast<float>(samples);
    store_first_hit(result_, x, y, p.first_hit, guides_.empty() ? GuideStatistics() : guides_[index(x, y)]);
  }

  const PixelSource& source_;
  const RenderSettings& settings_;
  TileGrid tiles_;
  std::uint32_t limit_, done_ = 0;  ///< samples of a stream: at most, and made so far in the active tiles
  std::vector<Pixel> pixels_;
  std::vector<GuideStatistics> guides_;
  std::vector<SamplePlanner> planners_;  ///< planner h sees half h
  std::vector<std::array<std::uint32_t, 2>> kept_samples_;
  RenderResult result_;
};

}  // namespace

RenderResult render_to_error(const PixelSource& source, const RenderSettings& settings) {
  return ErrorRenderer(source, settings).run();
}

}  // namespace sturm
