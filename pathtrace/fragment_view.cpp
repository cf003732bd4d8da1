#include "pathtrace/fragment_view.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <string>

#include "io/error.h"
#include "pathtrace/embree_rays.h"
#include "pathtrace/path_tracer.h"

namespace sturm {

namespace {

using Eigen::Vector3f;

/// Sums over the samples of one piece of surface; its first sample says which plane it is.
struct Piece {
  Vector3f point, normal;
  float pixel_size;
  bool surroundings, emits;
  Eigen::Vector3d position{0.0, 0.0, 0.0}, normals{0.0, 0.0, 0.0}, radiance{0.0, 0.0, 0.0}, albedo{0.0, 0.0, 0.0};
  Eigen::Vector3d squares{0.0, 0.0, 0.0};
  Eigen::Vector2d places{0.0, 0.0};
  Eigen::Matrix2d place_squares = Eigen::Matrix2d::Zero();
  int count = 0, cover = 0;  ///< samples that were shaded, samples that met it
};

struct Seen {
  Vector3f point, normal, radiance, albedo{0.0f, 0.0f, 0.0f};
  Eigen::Vector2d place{0.5, 0.5};  ///< within the pixel
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
    piece.squares += seen.radiance.cast<double>().cwiseAbs2();
    ++piece.count;
    cover(piece, seen);
  }

  /// A sample that counts for the size of its piece alone. False where there is no such piece yet.
  bool add_cover(const Seen& seen) {
    const std::size_t before = pieces_.size();
    Piece& piece = of(seen);
    if (pieces_.size() > before) {
      pieces_.pop_back();
      return false;
    }
    piece.position += seen.point.cast<double>();
    cover(piece, seen);
    return true;
  }

  bool emits() const {
    return std::any_of(pieces_.begin(), pieces_.end(), [](const Piece& p) { return p.emits; });
  }

  void append_to(std::vector<Fragment>& list, int samples) const {
    for (const Piece& p : pieces_) {
      Fragment f;
      const Eigen::Vector3d mean = p.position / p.cover;
      f.position = (p.surroundings ? Eigen::Vector3d(mean.normalized()) : mean).cast<float>();
      f.normal = p.surroundings ? Vector3f(Vector3f::Zero()) : Vector3f(p.normals.normalized().cast<float>());
      f.radiance = (p.radiance / p.count).cast<float>();
      f.albedo = (p.albedo / p.count).cast<float>();
      // Of a single sample nothing is known: as uncertain as it is bright.
      const Eigen::Vector3d square = (p.radiance / p.count).cwiseAbs2();
      f.variance = (p.count > 1 ? Eigen::Vector3d((p.squares / p.count - square).cwiseMax(0.0) / (p.count - 1)) : square).cast<float>();
      f.share = static_cast<float>(static_cast<double>(p.cover) / samples);
      const Eigen::Vector2d middle = p.places / p.cover;
      const Eigen::Matrix2d spread = p.place_squares / p.cover - middle * middle.transpose();
      f.middle = middle.cast<float>();
      f.spread = Vector3f(static_cast<float>(spread(0, 0)), static_cast<float>(spread(0, 1)), static_cast<float>(spread(1, 1)));
      f.surroundings = p.surroundings;
      f.emits = p.emits;
      list.push_back(f);
    }
  }

 private:
  static void cover(Piece& piece, const Seen& seen) {
    piece.places += seen.place;
    piece.place_squares += seen.place * seen.place.transpose();
    ++piece.cover;
  }

  static constexpr std::size_t most = 8;
  static constexpr float same_way = 0.906f;  // cos 25°

  /// The piece that a sample belongs to; the one whose plane is nearest where there is no room for more.
  Piece& of(const Seen& seen) {
    Piece* nearest = nullptr;
    float nearest_distance = std::numeric_limits<float>::infinity();
    for (Piece& p : pieces_) {
      if (p.surroundings != seen.surroundings) continue;
      const float distance = p.surroundings ? 0.0f : std::abs(p.normal.dot(seen.point - p.point)) / p.pixel_size;
      if (p.surroundings || (p.emits == seen.emits && p.normal.dot(seen.normal) > same_way && distance <= 1.0f)) return p;
      if (distance < nearest_distance) nearest = &p, nearest_distance = distance;
    }
    if (pieces_.size() == most) return nearest ? *nearest : pieces_.front();
    return pieces_.emplace_back(Piece{seen.point, seen.normal, seen.pixel_size, seen.surroundings, seen.emits});
  }

  std::vector<Piece> pieces_;
};

void add(RenderCounters& total, const RenderCounters& part) {
  total.camera += part.camera;
  total.bounce_rays += part.bounce_rays;
  total.shadow_rays += part.shadow_rays;
}

/// Traces one ray and, with a tracer, shades what it meets; numbers.begin_block is the caller's.
Seen seen_along(const Scene& scene, const PathTracer* tracer, const Vector3f& origin, const Vector3f& direction, double pixel_slope,
                VertexNumbers& numbers, std::uint32_t sample, RenderCounters& counters) {
  Seen seen;
  seen.radiance = Vector3f::Zero();
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
  if (!tracer) return seen;
  seen.radiance = tracer->radiance(point, direction, numbers, sample, counters);
  if (!seen.radiance.allFinite()) throw RuntimeFailure("a sample of the sharp view is not finite");
  return seen;
}

/// Renders pixel by pixel.
class FragmentRenderer {
 public:
  FragmentRenderer(const Scene& scene, int width, const ChiefRays& chief_rays, double pixel_slope, const RenderSettings& settings)
      : scene_(scene),
        tracer_(scene, settings),
        width_(width),
        chief_rays_(chief_rays),
        pixel_slope_(pixel_slope),
        settings_(settings),
        samples_(static_cast<std::uint32_t>(settings.samples_per_pixel)) {}

  PixelPieces pieces_of(int x, int y, RenderCounters& counters) const {
    const PixelSequence sequence = sequence_of(x, y);
    VertexNumbers numbers(sequence);
    PixelPieces pieces;
    for (std::uint32_t i = 0; i < samples_; ++i) {
      if (i % CameraRayBlock::size == 0) numbers.begin_block(i);
      if (const auto seen = sample(x, y, i, &tracer_, sequence, numbers, counters)) pieces.add(*seen);
    }
    return pieces;
  }

  /// More samples that are not shaded, of a pixel where a lamp begins: it is so much brighter than all around that its share must be known
  /// better than by the few that are. What they find first is shaded once.
  int refine(int x, int y, PixelPieces& pieces, RenderCounters& counters) const {
    const PixelSequence sequence = sequence_of(x, y);
    VertexNumbers numbers(sequence);
    for (std::uint32_t i = samples_; i < samples_ + outline_samples; ++i) {
      const auto seen = sample(x, y, i, nullptr, sequence, numbers, counters);
      if (!seen || pieces.add_cover(*seen)) continue;
      numbers.begin_block(i);
      pieces.add(*sample(x, y, i, &tracer_, sequence, numbers, counters));
    }
    return static_cast<int>(samples_) + outline_samples;
  }

 private:
  static constexpr int outline_samples = 256;

  PixelSequence sequence_of(int x, int y) const { return {settings_.sequence, settings_.seed, static_cast<std::uint32_t>(y * width_ + x)}; }
  std::optional<Seen> sample(int x, int y, std::uint32_t i, const PathTracer* tracer, const PixelSequence& sequence, VertexNumbers& numbers,
                             RenderCounters& counters) const {
    const auto film = sequence.pair(i, dimension::film);
    const auto chief = chief_rays_(x + unit_double(film.x), y + unit_double(film.y));
    if (!chief) return std::nullopt;
    Seen seen = seen_along(scene_, tracer, chief->origin.cast<float>(), chief->direction.cast<float>(), pixel_slope_, numbers, i, counters);
    seen.place = {unit_double(film.x), unit_double(film.y)};
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

FragmentImage render_fragments(const Scene& scene, int width, int height, const ChiefRays& chief_rays, double pixel_slope,
                               const RenderSettings& settings, RenderCounters& counters) {
  const FragmentRenderer renderer(scene, width, chief_rays, pixel_slope, settings);
  const auto index = [width](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  };
  std::vector<PixelPieces> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::vector<std::uint8_t> lamps(pixels.size());
  std::mutex merging;
  std::atomic<int> finished{0};
  const auto for_rows = [&](const auto& work) {
    tbb::parallel_for(0, height, [&](int y) {
      RenderCounters of_row;
      for (int x = 0; x < width; ++x) work(x, y, of_row);
      const std::lock_guard lock(merging);
      add(counters, of_row);  // integers: the order does not matter
    });
  };
  for_rows([&](int x, int y, RenderCounters& of_row) {
    pixels[index(x, y)] = renderer.pieces_of(x, y, of_row);
    lamps[index(x, y)] = pixels[index(x, y)].emits();
    if (x == width - 1 && settings.progress) settings.progress(static_cast<double>(++finished) / height);
  });
  std::vector<int> samples(pixels.size(), settings.samples_per_pixel);
  for_rows([&](int x, int y, RenderCounters& of_row) {
    bool near_lamp = false;
    for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u) near_lamp = near_lamp || lamps[index(u, v)];
    if (near_lamp) samples[index(x, y)] = renderer.refine(x, y, pixels[index(x, y)], of_row);
  });
  FragmentImage image{width, height, {0}, {}};
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    pixels[i].append_to(image.fragments, samples[i]);
    image.first.push_back(static_cast<std::uint32_t>(image.fragments.size()));
  }
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
        sum += seen_along(scene, &tracer, origin, direction, 0.0, numbers, i, of_range).radiance.cast<double>();
      }
      radiance[k] = (sum / settings.samples_per_pixel).cast<float>();
    }
    const std::lock_guard lock(merging);
    add(counters, of_range);
  });
  return radiance;
}

}  // namespace sturm
