#include "pathtrace/render.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <mutex>
#include <optional>
#include <string>

#include "io/error.h"
#include "pathtrace/camera_hits.h"
#include "pathtrace/film.h"
#include "pathtrace/guided_pixel.h"
#include "pathtrace/path_tracer.h"

namespace sturm {

namespace {

constexpr int tile_size = 16;

[[noreturn]] void fail_on_sample(int x, int y, std::uint32_t sample, std::uint64_t seed) {
  throw RuntimeFailure("a sample is not finite: pixel (" + std::to_string(x) + ", " + std::to_string(y) + "), sample " +
                       std::to_string(sample) + ", seed " + std::to_string(seed));
}

/// Renders pixel by pixel into images that other threads fill elsewhere. Camera: EyeCamera or ViewCamera.
template <class Camera>
class PixelRenderer {
 public:
  PixelRenderer(const Scene& scene, const Camera& camera, const RenderSettings& settings, RenderResult& result)
      : scene_(scene), camera_(camera), settings_(settings), tracer_(scene, settings), result_(result) {
    if constexpr (can_guide)
      if (settings.guide_emitters) guide_.emplace(scene, camera);
  }

  void render_pixel(int x, int y, RenderCounters& counters) const {
    const PixelSequence sequence(settings_.sequence, settings_.seed, static_cast<std::uint32_t>(y * camera_.width() + x));
    PixelStatistics radiance;
    FirstHitStatistics first_hit;
    VertexNumbers numbers(sequence);
    CameraHits hits;
    std::optional<GuidedPixel> guided;
    if (guide_ && !guide_->empty()) guided.emplace(*guide_, x, y, sequence);
    const auto samples = static_cast<std::uint32_t>(settings_.samples_per_pixel);
    for (std::uint32_t first = 0; first < samples; first += CameraRayBlock::size) {
      const int count = static_cast<int>(std::min<std::uint32_t>(CameraRayBlock::size, samples - first));
      trace_camera_rays(scene_, camera_, x, y, first, count, sequence, hits);
      numbers.begin_block(first);
      for (int i = 0; i < count; ++i) {
        if constexpr (Camera::weighted)
          count_with_losses(counters.camera, hits.rays.status[i]);
        else
          sturm::count(counters.camera, hits.rays.status[i]);
        if (hits.rays.status[i] == LaunchStatus::dropped) continue;
        Eigen::Vector3f value = Eigen::Vector3f::Zero();
        if (hits.hit(i)) {
          const Eigen::Vector3f direction = hits.direction(i);
          const SurfacePoint point = scene_.surface_point(hits.record(i), hits.origin(i), direction, hits.distance(i));
          const std::uint32_t sample = first + static_cast<std::uint32_t>(i);
          const float emission_weight = guided && point.emitter >= 0 ? guided->plain_weight(point.emitter, sample) : 1.0f;
          value = tracer_.radiance(point, direction, numbers, sample, counters, emission_weight);
          if (!value.allFinite()) fail_on_sample(x, y, first + static_cast<std::uint32_t>(i), settings_.seed);
          first_hit.add(point.albedo, point.normal, hits.distance(i));
        } else {
          if (scene_.has_environment()) value = scene_.environment(hits.direction(i));
          first_hit.add_miss();
        }
        if constexpr (Camera::weighted) value *= hits.rays.weight[i];  // also what a ray sees that meets nothing
        if (guided && guided->active()) value += guided->sample(first + static_cast<std::uint32_t>(i), counters);
        radiance.add(value);
      }
    }
    store(x, y, radiance, first_hit);
  }

 private:
  void store(int x, int y, const PixelStatistics& radiance, const FirstHitStatistics& first_hit) const {
    for (int k = 0; k < 3; ++k) {
      result_.radiance.at(x, y)[k] = static_cast<float>(radiance.mean(k));
      result_.variance.at(x, y)[k] = static_cast<float>(radiance.variance(k));
      result_.albedo.at(x, y)[k] = static_cast<float>(first_hit.albedo(k));
      result_.normal.at(x, y)[k] = static_cast<float>(first_hit.normal(k));
    }
    *result_.depth.at(x, y) = first_hit.depth();
  }

  const Scene& scene_;
  const Camera& camera_;
  const RenderSettings& settings_;
  PathTracer tracer_;
  RenderResult& result_;
  static constexpr bool can_guide = std::is_same_v<Camera, EyeCamera>;  ///< of the others the footprint is not known here
  std::optional<SceneGuide> guide_;
};

void add(RenderCounters& total, const RenderCounters& part) {
  total.camera += part.camera;
  total.bounce_rays += part.bounce_rays;
  total.shadow_rays += part.shadow_rays;
  total.guided_rays += part.guided_rays;
  total.guided_hits += part.guided_hits;
}

template <class Camera>
RenderResult render_with(const Scene& scene, const Camera& camera, const RenderSettings& settings) {
  const int width = camera.width(), height = camera.height();
  RenderResult result{Image(width, height, 3), Image(width, height, 3), Image(width, height, 3),
                      Image(width, height, 3), Image(width, height, 1), {}};
  const PixelRenderer<Camera> renderer(scene, camera, settings, result);
  std::mutex merging;
  std::atomic<long long> finished{0};
  const double pixels = static_cast<double>(width) * height;
  const tbb::blocked_range2d<int> range(0, height, tile_size, 0, width, tile_size);
  tbb::parallel_for(range, [&](const tbb::blocked_range2d<int>& tile) {
    RenderCounters counters;
    for (int y = tile.rows().begin(); y < tile.rows().end(); ++y)
      for (int x = tile.cols().begin(); x < tile.cols().end(); ++x) renderer.render_pixel(x, y, counters);
    const long long done = finished += static_cast<long long>(tile.rows().size() * tile.cols().size());
    if (settings.progress) settings.progress(static_cast<double>(done) / pixels);
    const std::lock_guard lock(merging);
    add(result.counters, counters);  // integers: the order does not matter
  });
  return result;
}

}  // namespace

RenderResult render(const Scene& scene, const EyeCamera& camera, const RenderSettings& settings) {
  return render_with(scene, camera, settings);
}

RenderResult render(const Scene& scene, const ViewCamera& camera, const RenderSettings& settings) {
  return render_with(scene, camera, settings);
}

}  // namespace sturm
