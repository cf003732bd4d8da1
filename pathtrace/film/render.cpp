#include "pathtrace/film/render.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <mutex>
#include <optional>
#include <string>

#include "io/files/error.h"
#include "pathtrace/cameras/camera_hits.h"
#include "pathtrace/film/adaptive_render.h"
#include "pathtrace/film/progressive_render.h"
#include "pathtrace/film/result_layers.h"
#include "pathtrace/guide/emitter_guide.h"
#include "pathtrace/guide/guided_pixel.h"
#include "pathtrace/guide/view_guide.h"
#include "pathtrace/integrator/path_tracer.h"

namespace sturm {

namespace {

constexpr int tile_size = 16;

[[noreturn]] void fail_on_sample(int x, int y, std::uint32_t sample, std::uint64_t seed) {
  throw RuntimeFailure("a sample is not finite: pixel (" + std::to_string(x) + ", " + std::to_string(y) + "), sample " +
                       std::to_string(sample) + ", seed " + std::to_string(seed));
}

/// What guides the samples of a camera.
template <Camera C>
struct GuideOf;
template <>
struct GuideOf<EyeCamera> {
  using type = EmitterGuide;
};
template <>
struct GuideOf<GeneralCamera> {
  using type = ViewGuide;
};

/// What a stream adds to the seed: beyond all seeds of documents (2⁵³) and of their left eyes (as much again).
constexpr std::uint64_t stream_seed = std::uint64_t{1} << 54;

/// The samples of pixels as a camera sees them.
template <Camera C>
class PixelRenderer final : public PixelSource {
  using Guide = typename GuideOf<C>::type;

 public:
  PixelRenderer(const Scene& scene, const C& camera, const RenderSettings& settings)
      : scene_(scene), camera_(camera), settings_(settings), tracer_(scene, settings) {
    if (settings.guide_emitters) guide_.emplace(scene, camera);
  }

  GuideUse guide_use() const { return guide_ ? guide_->use() : GuideUse::not_asked; }
  int width() const override { return camera_.width(); }
  int height() const override { return camera_.height(); }

  void add_samples(int x, int y, const SampleRange& range, const PixelRecords& records,
                   RenderCounters& counters) const override {
    const PixelSequence sequence(settings_.sequence,
                                 settings_.seed + stream_seed * static_cast<std::uint64_t>(range.stream),
                                 static_cast<std::uint32_t>(y * camera_.width() + x));
    VertexNumbers numbers(sequence);
    CameraHits hits;
    FirstVertices vertices;
    std::optional<GuidedPixel<Guide>> guided;
    if (guide_ && !guide_->empty()) guided.emplace(*guide_, x, y, sequence);
    const std::uint32_t end = range.first + range.count;
    for (std::uint32_t first = range.first; first < end; first += CameraRayBlock::size) {
      const int count = static_cast<int>(std::min<std::uint32_t>(CameraRayBlock::size, end - first));
      trace_camera_rays(scene_, camera_, x, y, first, count, sequence, hits);
      numbers.begin_block(first, count);
      for (int i = 0; i < count; ++i)
        if (hits.hit(i))
          vertices.at[i] = scene_.surface_point(hits.record(i), hits.origin(i), hits.direction(i), hits.distance(i));
      tracer_.light(vertices, hits, first, count, numbers, counters);
      for (int i = 0; i < count; ++i) {
        if constexpr (C::weighted)
          count_with_losses(counters.camera, hits.rays.status[i]);
        else
          sturm::count(counters.camera, hits.rays.status[i]);
        if (hits.rays.status[i] == LaunchStatus::dropped) continue;
        Eigen::Vector3f value = Eigen::Vector3f::Zero();
        if (hits.hit(i)) {
          const SurfacePoint& point = vertices.at[i];
          const std::uint32_t sample = first + static_cast<std::uint32_t>(i);
          FirstVertex known;
          if (guided && point.emitter >= 0) known.emission_weight = guided->plain_weight(point.emitter, sample);
          if (vertices.lit) known.direct_light = &vertices.direct_light[i];
          value = tracer_.radiance(point, hits.direction(i), numbers, sample, counters, known);
          if constexpr (C::weighted) value *= hits.rays.weight[i];
          if (!value.allFinite()) fail_on_sample(x, y, first + static_cast<std::uint32_t>(i), settings_.seed);
          records.first_hit.add(point.albedo, point.normal, hits.distance(i));
          if (records.guide) records.guide->add(point.albedo, point.normal, hits.distance(i));
        } else {
          if (scene_.has_environment() && goes_on(hits.rays.status[i])) {
            value = scene_.environment(hits.direction(i));
            if constexpr (C::weighted) value *= hits.rays.weight[i];
          }
          records.first_hit.add_miss();
          if (records.guide) records.guide->add_miss();
        }
        if (guided && guided->active()) value += guided->sample(first + static_cast<std::uint32_t>(i), counters);
        records.radiance.add(value);
      }
    }
  }

 private:
  const Scene& scene_;
  const C& camera_;
  const RenderSettings& settings_;
  PathTracer tracer_;
  std::optional<Guide> guide_;
};

/// Every pixel in one go, its statistics on the stack of one thread.
template <Camera C>
RenderResult render_at_once(const PixelRenderer<C>& renderer, const RenderSettings& settings) {
  const int width = renderer.width(), height = renderer.height();
  RenderResult result = empty_result(width, height, settings);
  const SampleRange all{0, 0, static_cast<std::uint32_t>(settings.samples_per_pixel)};
  std::mutex merging;
  std::atomic<long long> finished{0};
  const double pixels = static_cast<double>(width) * height;
  const tbb::blocked_range2d<int> range(0, height, tile_size, 0, width, tile_size);
  tbb::parallel_for(range, [&](const tbb::blocked_range2d<int>& tile) {
    RenderCounters counters;
    for (int y = tile.rows().begin(); y < tile.rows().end(); ++y)
      for (int x = tile.cols().begin(); x < tile.cols().end(); ++x) {
        PixelStatistics radiance;
        FirstHitStatistics first_hit;
        GuideStatistics guide;
        renderer.add_samples(x, y, all, {radiance, first_hit, settings.guide_layers ? &guide : nullptr}, counters);
        store_radiance(result, x, y, radiance);
        store_first_hit(result, x, y, first_hit, guide);
      }
    const long long done = finished += static_cast<long long>(tile.rows().size() * tile.cols().size());
    if (settings.progress) settings.progress(static_cast<double>(done) / pixels);
    const std::lock_guard lock(merging);
    result.counters += counters;  // integers: the order does not matter
  });
  result.passes.samples_spent = result.passes.samples_kept = static_cast<std::uint64_t>(pixels) * all.count;
  return result;
}

template <Camera C>
RenderResult render_with(const Scene& scene, const C& camera, const RenderSettings& settings) {
  const PixelRenderer<C> renderer(scene, camera, settings);
  RenderResult result = settings.relative_error ? render_to_error(renderer, settings)
                        : settings.after_pass   ? render_in_passes(renderer, settings)
                                                : render_at_once(renderer, settings);
  result.guide_use = renderer.guide_use();
  return result;
}

}  // namespace

RenderResult render(const Scene& scene, const EyeCamera& camera, const RenderSettings& settings) {
  return render_with(scene, camera, settings);
}

RenderResult render(const Scene& scene, const GeneralCamera& camera, const RenderSettings& settings) {
  return render_with(scene, camera, settings);
}

}  // namespace sturm
