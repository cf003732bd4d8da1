#include "pathtrace/fragment_view.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <string>

#include "io/error.h"
#include "pathtrace/embree_rays.h"
#include "pathtrace/path_tracer.h"

namespace sturm {

namespace {

using Eigen::Vector3f;

double luma(const Eigen::Vector3d& rgb) {
  return 0.2126 * rgb.x() + 0.7152 * rgb.y() + 0.0722 * rgb.z();
}

/// Sums over the samples of one piece of surface; its first sample says which plane it is.
struct Piece {
  Vector3f point, normal;
  float pixel_size;
  bool surroundings, emits;
  Eigen::Vector3d position{0.0, 0.0, 0.0}, normals{0.0, 0.0, 0.0}, radiance{0.0, 0.0, 0.0}, albedo{0.0, 0.0, 0.0};
  double luma_squares = 0.0;
  int count = 0;
};

struct Seen {
  Vector3f point, normal, radiance, albedo{0.0f, 0.0f, 0.0f};
  float pixel_size = 0.0f;
  bool surroundings = false, emits = false;
};

/// The pieces of one pixel.
class PixelPieces {
 public:
  void add(const Seen& seen) {
    Piece& piece = of(seen);
    piece.position += seen.point.cast<double>();
    piece.normals += seen.normal.cast<double>();
    piece.radiance += seen.radiance.cast<double>();
    piece.albedo += seen.albedo.cast<double>();
    piece.luma_squares += luma(seen.radiance.cast<double>()) * luma(seen.radiance.cast<double>());
    piece.emits = piece.emits || seen.emits;
    ++piece.count;
  }

  void append_to(std::vector<Fragment>& list, int samples) const {
    for (int i = 0; i < count_; ++i) {
      const Piece& p = pieces_[static_cast<std::size_t>(i)];
      Fragment f;
      const Eigen::Vector3d mean = p.position / p.count;
      f.position = (p.surroundings ? Eigen::Vector3d(mean.normalized()) : mean).cast<float>();
      f.normal = p.surroundings ? Vector3f(Vector3f::Zero()) : Vector3f(p.normals.normalized().cast<float>());
      f.radiance = (p.radiance / p.count).cast<float>();
      f.albedo = (p.albedo / p.count).cast<float>();
      const double bright = luma(p.radiance / p.count);
      // Of a single sample nothing is known: as uncertain as it is bright.
      f.variance =
          static_cast<float>(p.count > 1 ? std::max(0.0, p.luma_squares / p.count - bright * bright) / (p.count - 1) : bright * bright);
      f.share = static_cast<float>(static_cast<double>(p.count) / samples);
      f.surroundings = p.surroundings;
      f.emits = p.emits;
      list.push_back(f);
    }
  }

 private:
  static constexpr int most = 8;
  static constexpr float same_way = 0.906f;  // cos 25°

  /// The piece that a sample belongs to; the one whose plane is nearest where there is no room for more.
  Piece& of(const Seen& seen) {
    int best = -1;
    float best_distance = std::numeric_limits<float>::infinity();
    for (int i = 0; i < count_; ++i) {
      const Piece& p = pieces_[static_cast<std::size_t>(i)];
      if (p.surroundings != seen.surroundings) continue;
      const float distance = p.surroundings ? 0.0f : std::abs(p.normal.dot(seen.point - p.point)) / p.pixel_size;
      const bool alike = p.surroundings || (p.normal.dot(seen.normal) > same_way && distance <= 1.0f);
      if (alike) return pieces_[static_cast<std::size_t>(i)];
      if (distance < best_distance) best = i, best_distance = distance;
    }
    if (count_ == most) return pieces_[static_cast<std::size_t>(best >= 0 ? best : 0)];
    Piece& fresh = pieces_[static_cast<std::size_t>(count_++)];
    fresh = Piece{seen.point, seen.normal, seen.pixel_size, seen.surroundings, seen.emits};
    return fresh;
  }

  std::array<Piece, most> pieces_;
  int count_ = 0;
};

void add(RenderCounters& total, const RenderCounters& part) {
  total.camera += part.camera;
  total.bounce_rays += part.bounce_rays;
  total.shadow_rays += part.shadow_rays;
}

/// Traces one ray and shades what it meets; numbers.begin_block is the caller's.
Seen seen_along(const Scene& scene, const PathTracer& tracer, const Vector3f& origin, const Vector3f& direction, double pixel_slope,
                VertexNumbers& numbers, std::uint32_t sample, RenderCounters& counters) {
  Seen seen;
  ++counters.camera.launched;
  RTCRayHit ray = ray_from(origin, direction);
  if (!intersect(scene.embree(), ray)) {
    seen.point = direction.normalized();
    seen.normal = Vector3f::Zero();
    seen.radiance = scene.environment(direction);
    seen.surroundings = true;
    return seen;
  }
  const SurfacePoint point = scene.surface_point(ray.hit, origin, direction, ray.ray.tfar);
  seen.point = point.position;
  seen.normal = point.normal.dot(direction) > 0.0f ? Vector3f(-point.normal) : point.normal;
  seen.emits = point.emitter >= 0 && point.normal.dot(direction) < 0.0f;
  if (std::holds_alternative<Diffuse>(point.material->surface)) seen.albedo = point.albedo;
  seen.pixel_size = static_cast<float>(pixel_slope) * (point.position - origin).norm();
  seen.radiance = tracer.radiance(point, direction, numbers, sample, counters);
  if (!seen.radiance.allFinite()) throw RuntimeFailure("a sample of the sharp view is not finite");
  return seen;
}

}  // namespace

FragmentImage render_fragments(const Scene& scene, int width, int height, const ChiefRays& chief_rays, double pixel_slope,
                               const RenderSettings& settings, RenderCounters& counters) {
  const PathTracer tracer(scene, settings);
  std::vector<std::vector<Fragment>> rows(static_cast<std::size_t>(height));
  FragmentImage image{
      width, height, std::vector<std::uint32_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) + 1), {}};
  std::mutex merging;
  std::atomic<int> finished{0};
  tbb::parallel_for(0, height, [&](int y) {
    RenderCounters of_row;
    for (int x = 0; x < width; ++x) {
      const PixelSequence sequence(settings.sequence, settings.seed, static_cast<std::uint32_t>(y * width + x));
      VertexNumbers numbers(sequence);
      PixelPieces pieces;
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(settings.samples_per_pixel); ++i) {
        if (i % CameraRayBlock::size == 0) numbers.begin_block(i);
        const auto film = sequence.pair(i, dimension::film);
        const auto chief = chief_rays(x + unit_double(film.x), y + unit_double(film.y));
        if (!chief) continue;
        pieces.add(seen_along(scene, tracer, chief->origin.cast<float>(), chief->direction.cast<float>(), pixel_slope, numbers, i, of_row));
      }
      auto& row = rows[static_cast<std::size_t>(y)];
      const std::size_t before = row.size();
      pieces.append_to(row, settings.samples_per_pixel);
      image.first[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x) + 1] =
          static_cast<std::uint32_t>(row.size() - before);
    }
    const int done = ++finished;
    if (settings.progress) settings.progress(static_cast<double>(done) / height);
    const std::lock_guard lock(merging);
    add(counters, of_row);  // integers: the order does not matter
  });
  for (std::size_t i = 1; i < image.first.size(); ++i) image.first[i] += image.first[i - 1];
  for (const auto& row : rows) image.fragments.insert(image.fragments.end(), row.begin(), row.end());
  return image;
}

std::vector<Vector3f> shade_places(const Scene& scene, std::size_t count, const std::function<PlaceRays(std::size_t)>& place,
                                   const RenderSettings& settings, RenderCounters& counters) {
  const PathTracer tracer(scene, settings);
  std::vector<Vector3f> radiance(count);
  std::mutex merging;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 64), [&](const tbb::blocked_range<std::size_t>& range) {
    RenderCounters of_range;
    for (std::size_t k = range.begin(); k < range.end(); ++k) {
      const PlaceRays at = place(k);
      const PixelSequence sequence(settings.sequence, settings.seed ^ (at.key >> 32 << 32), static_cast<std::uint32_t>(at.key));
      VertexNumbers numbers(sequence);
      Eigen::Vector3d sum(0.0, 0.0, 0.0);
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(settings.samples_per_pixel); ++i) {
        if (i % CameraRayBlock::size == 0) numbers.begin_block(i);
        const auto& [origin, direction] = at.rays[i % at.rays.size()];
        sum += seen_along(scene, tracer, origin, direction, 0.0, numbers, i, of_range).radiance.cast<double>();
      }
      radiance[k] = (sum / settings.samples_per_pixel).cast<float>();
    }
    const std::lock_guard lock(merging);
    add(counters, of_range);
  });
  return radiance;
}

}  // namespace sturm
