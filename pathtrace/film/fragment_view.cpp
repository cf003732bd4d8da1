#include "pathtrace/film/fragment_view.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <string>

#include "io/files/error.h"
#include "pathtrace/film/pixel_pieces.h"
#include "pathtrace/integrator/path_tracer.h"
#include "pathtrace/scene/embree_rays.h"

namespace sturm {

namespace {

using Eigen::Vector3f;

constexpr std::uint64_t outline_seed = 0x4f55544cull;  // added to the seed of samples that are not shaded

/// Pixels of a tile share one sequence, each with its own stretch in the order of a Z-curve: 4, 16, … pixels next to
/// one another have as many times the samples of one pixel, as evenly spread as those are, so that what averages over
/// pixels, filter and blur, has less noise [AhmedWonka2020].
struct SharedSequence {
  static constexpr int tile_bits = 5, tile = 1 << tile_bits;

  static std::uint32_t tile_of(int x, int y, int width) {
    return static_cast<std::uint32_t>((y >> tile_bits) * ((width + tile - 1) >> tile_bits) + (x >> tile_bits));
  }
  static std::uint32_t place_in_tile(int x, int y) {
    std::uint32_t place = 0;
    for (int bit = 0; bit < tile_bits; ++bit)
      place |= static_cast<std::uint32_t>((x >> bit & 1) | (y >> bit & 1) << 1) << 2 * bit;
    return place;
  }
};

SeenSurface seen_surroundings(const Scene& scene, const Vector3f& direction) {
  SeenSurface seen;
  seen.point = direction.normalized();
  seen.radiance = seen.direct = scene.environment(direction);
  seen.surroundings = true;
  return seen;
}

/// Not shaded.
SeenSurface seen_surface(const SurfacePoint& point, const Vector3f& origin, const Vector3f& direction,
                         double pixel_slope) {
  SeenSurface seen;
  seen.point = point.position;
  seen.normal = point.normal.dot(direction) > 0.0f ? Vector3f(-point.normal) : point.normal;
  seen.emits = point.emitter >= 0 && point.normal.dot(direction) < 0.0f;
  seen.lambertian = std::holds_alternative<Diffuse>(point.material->surface);
  seen.albedo = point.albedo;
  seen.pixel_size = static_cast<float>(pixel_slope) * (point.position - origin).norm();
  return seen;
}

Vector3f radiance_along(const Scene& scene, const PathTracer& tracer, const Vector3f& origin, const Vector3f& direction,
                        VertexNumbers& numbers, std::uint32_t sample, RenderCounters& counters) {
  ++counters.camera.launched;
  RTCRayHit ray = ray_from(origin, direction);
  if (!intersect(scene.embree(), ray)) return scene.environment(direction);
  const SurfacePoint point = scene.surface_point(ray.hit, origin, direction, ray.ray.tfar);
  const Vector3f radiance = tracer.radiance(point, direction, numbers, sample, counters);
  if (!radiance.allFinite()) throw RuntimeFailure("a sample of the sharp view is not finite");
  return radiance;
}

/// Rays of one block, what they met, and where in the pixel they belong.
struct ChiefBlock {
  CameraHits hits;
  FirstVertices vertices;
  Eigen::Vector2d places[CameraRayBlock::size];
};

/// Renders pixel by pixel.
class FragmentRenderer {
 public:
  FragmentRenderer(const Scene& scene, int width, const ChiefRays& chief_rays, double pixel_slope,
                   const RenderSettings& settings)
      : scene_(scene),
        tracer_(scene, settings),
        width_(width),
        chief_rays_(chief_rays),
        pixel_slope_(pixel_slope),
        settings_(settings),
        samples_(static_cast<std::uint32_t>(settings.samples_per_pixel)) {}

  PixelPieces pieces_of(int x, int y, RenderCounters& counters) const {
    const PixelSequence sequence(settings_.sequence, settings_.seed, SharedSequence::tile_of(x, y, width_));
    VertexNumbers numbers(sequence);
    ChiefBlock block;
    PixelPieces pieces;
    const std::uint32_t begin = SharedSequence::place_in_tile(x, y) * samples_, end = begin + samples_;
    for (std::uint32_t first = begin; first != end;) {
      const int count = static_cast<int>(std::min<std::uint32_t>(CameraRayBlock::size, end - first));
      trace(x, y, first, count, sequence, block, counters);
      numbers.begin_block(first, count);
      tracer_.light(block.vertices, block.hits, first, count, numbers, counters);
      for (int i = 0; i < count; ++i)
        if (goes_on(block.hits.rays.status[i]))
          pieces.add(shaded(block, i, first + static_cast<std::uint32_t>(i), numbers, counters));
      first += static_cast<std::uint32_t>(count);
    }
    return pieces;
  }

  /// More samples that are not shaded, of a pixel where a lamp begins: it is so much brighter than all around that its
  /// share must be known better than by the few that are. What they find first is shaded once.
  int refine(int x, int y, PixelPieces& pieces, RenderCounters& counters) const {
    const PixelSequence sequence(settings_.sequence, settings_.seed + outline_seed,
                                 static_cast<std::uint32_t>(y * width_ + x));
    VertexNumbers numbers(sequence);
    ChiefBlock block;
    block.vertices.lit = false;
    for (std::uint32_t first = 0; first < outline_samples; first += CameraRayBlock::size) {
      trace(x, y, first, CameraRayBlock::size, sequence, block, counters);
      numbers.begin_block(first);
      for (int i = 0; i < CameraRayBlock::size; ++i)
        if (goes_on(block.hits.rays.status[i]) && !pieces.add_cover(unshaded(block, i)))
          pieces.add(shaded(block, i, first + static_cast<std::uint32_t>(i), numbers, counters));
    }
    return static_cast<int>(samples_ + outline_samples);
  }

 private:
  static constexpr std::uint32_t outline_samples = 256;

  void trace(int x, int y, std::uint32_t first, int count, const PixelSequence& sequence, ChiefBlock& block,
             RenderCounters& counters) const {
    CameraHits& hits = block.hits;
    for (int i = 0; i < count; ++i) {
      const auto film = sequence.pair(first + static_cast<std::uint32_t>(i), dimension::film);
      block.places[i] = {unit_double(film.x), unit_double(film.y)};
      const auto chief = chief_rays_(x + block.places[i].x(), y + block.places[i].y());
      hits.rays.status[i] = chief ? LaunchStatus::ok : LaunchStatus::dropped;
      for (int k = 0; k < 3; ++k) {
        hits.rays.origin[k][i] = chief ? static_cast<float>(chief->origin[k]) : 0.0f;
        hits.rays.direction[k][i] = chief ? static_cast<float>(chief->direction[k]) : 0.0f;
      }
      if (chief) ++counters.camera.launched;
    }
    for (int i = count; i < CameraRayBlock::size; ++i) {
      hits.rays.status[i] = LaunchStatus::dropped;
      for (int k = 0; k < 3; ++k) hits.rays.origin[k][i] = hits.rays.direction[k][i] = 0.0f;
    }
    trace_packets(scene_, count, hits);
    for (int i = 0; i < count; ++i)
      if (hits.hit(i))
        block.vertices.at[i] =
            scene_.surface_point(hits.record(i), hits.origin(i), hits.direction(i), hits.distance(i));
  }

  SeenSurface unshaded(const ChiefBlock& block, int i) const {
    const Vector3f direction = block.hits.direction(i);
    SeenSurface seen = block.hits.hit(i)
                           ? seen_surface(block.vertices.at[i], block.hits.origin(i), direction, pixel_slope_)
                           : seen_surroundings(scene_, direction);
    seen.place = block.places[i];
    return seen;
  }

  SeenSurface shaded(const ChiefBlock& block, int i, std::uint32_t sample, VertexNumbers& numbers,
                     RenderCounters& counters) const {
    SeenSurface seen = unshaded(block, i);
    if (seen.surroundings) return seen;
    FirstVertex known;
    if (block.vertices.lit) known.direct_light = &block.vertices.direct_light[i];
    known.reflected_once = &seen.direct;
    seen.radiance = tracer_.radiance(block.vertices.at[i], block.hits.direction(i), numbers, sample, counters, known);
    if (!seen.radiance.allFinite()) throw RuntimeFailure("a sample of the sharp view is not finite");
    return seen;
  }

  const Scene& scene_;
  PathTracer tracer_;
  int width_;
  const ChiefRays& chief_rays_;
  double pixel_slope_;
  const RenderSettings& settings_;
  std::uint32_t samples_;
};

}  // namespace

FragmentImage render_fragments(const Scene& scene, int width, int height, const ChiefRays& chief_rays,
                               double pixel_slope, const RenderSettings& settings, RenderCounters& counters) {
  const FragmentRenderer renderer(scene, width, chief_rays, pixel_slope, settings);
  const auto index = [width](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  };
  std::vector<PixelPieces> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  enum Lamp : std::uint8_t { none, some, nothing_else };
  std::vector<Lamp> lamps(pixels.size());
  std::mutex merging;
  std::atomic<int> finished{0};
  const auto for_rows = [&](const auto& work) {
    tbb::parallel_for(0, height, [&](int y) {
      RenderCounters of_row;
      for (int x = 0; x < width; ++x) work(x, y, of_row);
      const std::lock_guard lock(merging);
      counters += of_row;  // integers: the order does not matter
    });
  };
  for_rows([&](int x, int y, RenderCounters& of_row) {
    pixels[index(x, y)] = renderer.pieces_of(x, y, of_row);
    const PixelPieces& pieces = pixels[index(x, y)];
    lamps[index(x, y)] = pieces.are_one_lamp() ? nothing_else : pieces.emits() ? some : none;
    if (x == width - 1 && settings.progress) settings.progress(static_cast<double>(++finished) / height);
  });
  std::vector<int> samples(pixels.size(), settings.samples_per_pixel);
  for_rows([&](int x, int y, RenderCounters& of_row) {
    bool near_lamp = false, within_lamp = true;
    for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u) {
        near_lamp = near_lamp || lamps[index(u, v)] != none;
        within_lamp = within_lamp && lamps[index(u, v)] == nothing_else;
      }
    if (near_lamp && !within_lamp) samples[index(x, y)] = renderer.refine(x, y, pixels[index(x, y)], of_row);
  });
  FragmentImage image{width, height, {0}, {}};
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    pixels[i].append_to(image.fragments, samples[i]);
    image.first.push_back(static_cast<std::uint32_t>(image.fragments.size()));
  }
  return image;
}

std::vector<Vector3f> shade_places(const Scene& scene, std::size_t count,
                                   const std::function<PlaceRays(std::size_t)>& place, const RenderSettings& settings,
                                   RenderCounters& counters) {
  const PathTracer tracer(scene, settings);
  std::vector<Vector3f> radiance(count);
  std::mutex merging;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 64), [&](const tbb::blocked_range<std::size_t>& range) {
    RenderCounters of_range;
    for (std::size_t k = range.begin(); k < range.end(); ++k) {
      const PlaceRays at = place(k);
      const PixelSequence sequence(settings.sequence, settings.seed ^ (at.key >> 32 << 32),
                                   static_cast<std::uint32_t>(at.key));
      VertexNumbers numbers(sequence);
      Eigen::Vector3d sum(0.0, 0.0, 0.0);
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(settings.samples_per_pixel); ++i) {
        if (i % CameraRayBlock::size == 0) numbers.begin_block(i);
        const auto& [origin, direction] = at.rays[i % at.rays.size()];
        sum += radiance_along(scene, tracer, origin, direction, numbers, i, of_range).cast<double>();
      }
      radiance[k] = (sum / settings.samples_per_pixel).cast<float>();
    }
    const std::lock_guard lock(merging);
    counters += of_range;
  });
  return radiance;
}

}  // namespace sturm
