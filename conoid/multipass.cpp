#include "conoid/multipass.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "conoid/pupil_passes.h"

namespace sturm {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;

/// A pixel-sized place of the world that the sharp view does not show: where it would be in the sharp view, and about how far.
struct Cell {
  static constexpr std::int32_t nowhere = std::numeric_limits<std::int32_t>::min();  ///< no chief ray goes there; x, y: of the picture
  static constexpr std::int32_t at_infinity = std::numeric_limits<std::int32_t>::max();
  std::int32_t x, y, depth, kind = 0;
  auto operator<=>(const Cell&) const = default;

  std::uint64_t key() const {  // FNV-1a over the four numbers
    std::uint64_t hash = 0xcbf29ce484222325ull;
    for (const std::int32_t v : {x, y, depth, kind}) hash = (hash ^ static_cast<std::uint32_t>(v)) * 0x100000001b3ull;
    return hash ^ (hash >> 29);
  }
};

/// One ray that met such a place.
struct Unseen {
  Cell cell;
  std::uint32_t pixel;
  std::uint32_t pass;
  auto operator<=>(const Unseen&) const = default;
};

/// All rays of one pixel: origin and direction, and how they move with the place in the pixel and with the point of the unit disc.
struct PixelRays {
  Sight sight;
  SightNeighbourhood around;
  Vector3f origin, direction;
  Eigen::Matrix<float, 3, 2> origin_by_place, direction_by_place, origin_by_pupil, direction_by_pupil;

  PixelRays(const SightField& field, const Vector2d& center) : sight(field.at(center)), around(field, center, sight) {
    origin = sight.origin.cast<float>();
    direction = sight.direction.cast<float>();
    origin_by_place = around.origin_by_place().cast<float>();
    direction_by_place = around.direction_by_place().cast<float>();
  }

  void bend(const Eigen::Matrix2d& slopes, double pupil_radius) {
    origin_by_pupil = (pupil_radius * sight.offsets(slopes)).cast<float>();
    direction_by_pupil = (pupil_radius * sight.directions(slopes)).cast<float>();
  }

  UnseenPlaces::Ray chief(const Vector2f& film) const {
    const Vector2f d = film - Vector2f(0.5f, 0.5f);
    return {origin + origin_by_place * d, direction + direction_by_place * d};
  }
  UnseenPlaces::Ray through(const PupilPass& pass) const {
    const UnseenPlaces::Ray c = chief(pass.film);
    return {c.origin + origin_by_pupil * pass.pupil, c.direction + direction_by_pupil * pass.pupil};
  }
};

constexpr int lanes = 8;

/// First hits of up to 8 rays: the distance in units of their directions, ∞ for nothing.
void first_hits(RTCScene scene, const UnseenPlaces::Ray* rays, int count, float* distance) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit8 packet;
  alignas(32) int valid[lanes];
  for (int i = 0; i < lanes; ++i) {
    const UnseenPlaces::Ray& ray = rays[i < count ? i : 0];
    valid[i] = i < count ? -1 : 0;
    packet.ray.org_x[i] = ray.origin.x();
    packet.ray.org_y[i] = ray.origin.y();
    packet.ray.org_z[i] = ray.origin.z();
    packet.ray.dir_x[i] = ray.direction.x();
    packet.ray.dir_y[i] = ray.direction.y();
    packet.ray.dir_z[i] = ray.direction.z();
    packet.ray.tnear[i] = 0.0f;
    packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
    packet.ray.time[i] = 0.0f;
    packet.ray.mask[i] = ~0u;
    packet.ray.flags[i] = 0;
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect8(valid, scene, &context, &packet);
  for (int i = 0; i < count; ++i)
    distance[i] = packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<float>::infinity() : packet.ray.tfar[i];
}

/// Finds what the sharp view knows of a point.
class SharpLookup {
 public:
  SharpLookup(const FragmentImage& view, int oversampling, double pixel_slope)
      : view_(view), oversampling_(oversampling), pixel_slope_(static_cast<float>(pixel_slope / oversampling)) {}

  /// Radiance of the fragment in the pixel of `place` (of the picture) on whose plane the point lies to a pixel's size; none
  /// if there is no such. `cell` is set to where the point would be.
  std::optional<Vector3f> find(const Vector2d& place, const Vector3f& point, float distance, bool surroundings, Cell& cell) const {
    const int x = static_cast<int>(std::floor(place.x() * oversampling_)), y = static_cast<int>(std::floor(place.y() * oversampling_));
    // 64 steps per factor e: 1.6 % of the distance.
    cell = {x, y, surroundings ? Cell::at_infinity : static_cast<std::int32_t>(std::floor(64.0f * std::log(distance))), 0};
    return in_pixel(x, y, point, distance, surroundings);
  }

 private:
  std::optional<Vector3f> in_pixel(int x, int y, const Vector3f& point, float distance, bool surroundings) const {
    if (x < 0 || y < 0 || x >= view_.width || y >= view_.height) return std::nullopt;
    const float pixel = pixel_slope_ * distance;
    const auto off_plane = [&](const Fragment& f) {
      if (f.surroundings != surroundings) return std::numeric_limits<float>::infinity();
      return surroundings ? 0.0f : std::abs(f.normal.dot(point - f.position));
    };
    float best = pixel;
    for (const Fragment& f : view_.at(x, y)) best = std::min(best, off_plane(f));
    // Several fragments may lie on one plane (a lamp in a ceiling): the pixel's mean over them.
    Vector3f sum = Vector3f::Zero();
    float share = 0.0f;
    for (const Fragment& f : view_.at(x, y)) {
      if (!(off_plane(f) <= std::min(best + 0.05f * pixel, pixel))) continue;
      sum += f.share * f.radiance;
      share += f.share;
    }
    if (!(share > 0.0f)) return std::nullopt;
    return Vector3f(sum / share);
  }

  const FragmentImage& view_;
  int oversampling_;
  float pixel_slope_;
};

struct PixelSum {
  Vector3d radiance{0.0, 0.0, 0.0};
  double unseen = 0.0;
};

class Passes {
 public:
  Passes(const FragmentImage& view, int oversampling, const SightField& field, RTCScene scene, const PassSettings& settings)
      : field_(field),
        scene_(scene),
        settings_(settings),
        lookup_(view, oversampling, field.plane().pixel_slope),
        oversampling_(oversampling),
        width_(field.plane().width),
        height_(field.plane().height),
        passes_(interleaved_passes(settings.passes)) {
    if (view.width != width_ * oversampling || view.height != height_ * oversampling)
      throw std::invalid_argument("passes: the sharp view does not cover the picture");
    if (settings.passes < 1 || settings.rays_per_place < 1) throw std::invalid_argument("passes: expected at least one");
    for (const auto& set : passes_) weights_.push_back(weights_of(set));
  }

  /// Sends all rays. `sums` gets what the sharp view knows, one entry per pixel; the result is what it does not know, sorted.
  std::vector<Unseen> trace(std::vector<PixelSum>& sums, PassCounters& counters) const {
    sums.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), {});
    std::vector<std::vector<Unseen>> rows(static_cast<std::size_t>(height_));
    std::vector<long long> lost(static_cast<std::size_t>(height_), 0);
    tbb::parallel_for(0, height_, [&](int y) {
      for (int x = 0; x < width_; ++x)
        if (!trace_pixel(x, y, sums[index(x, y)], rows[static_cast<std::size_t>(y)])) ++lost[static_cast<std::size_t>(y)];
    });
    std::vector<Unseen> all;
    for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
    tbb::parallel_sort(all.begin(), all.end());
    for (const long long n : lost) counters.lost_pixels += n;
    counters.rays = (static_cast<long long>(width_) * height_ - counters.lost_pixels) * settings_.passes;
    counters.unseen_rays = static_cast<long long>(all.size());
    return all;
  }

  /// The places of sorted rays, with up to rays_per_place of each, evenly chosen; `begins` gets where each place begins in `unseen`.
  UnseenPlaces places(const std::vector<Unseen>& unseen, std::vector<std::size_t>& begins) const {
    begins.clear();
    for (std::size_t i = 0; i < unseen.size(); ++i)
      if (i == 0 || unseen[i].cell != unseen[i - 1].cell) begins.push_back(i);
    UnseenPlaces result;
    std::vector<const Unseen*> chosen;
    for (std::size_t k = 0; k < begins.size(); ++k) {
      const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : unseen.size(), count = end - begins[k];
      const std::size_t taken = std::min(count, static_cast<std::size_t>(settings_.rays_per_place));
      for (std::size_t i = 0; i < taken; ++i) chosen.push_back(&unseen[begins[k] + i * count / taken]);
      result.first.push_back(static_cast<std::uint32_t>(chosen.size()));
      result.keys.push_back(unseen[begins[k]].cell.key());
    }
    result.rays.resize(chosen.size());
    tbb::parallel_for(std::size_t{0}, chosen.size(), [&](std::size_t i) { result.rays[i] = ray_of(*chosen[i]); });
    return result;
  }

  double weight_of(const Unseen& u) const { return weights_[set_of(u.pixel)][u.pass]; }
  Vector2d place_of(const Cell& cell) const { return {(cell.x + 0.5) / oversampling_, (cell.y + 0.5) / oversampling_}; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  std::size_t set_of(std::uint32_t pixel) const {
    const std::uint32_t x = pixel % static_cast<std::uint32_t>(width_), y = pixel / static_cast<std::uint32_t>(width_);
    return y % 4 * 4 + x % 4;
  }

  std::vector<double> weights_of(const std::vector<PupilPass>& set) const {
    std::vector<double> weights;
    double sum = 0.0;
    const double a = field_.eye().pupil_radius_m;
    for (const PupilPass& pass : set) {
      weights.push_back(std::pow(10.0, -field_.eye().stiles_crawford_per_m2 * a * a * static_cast<double>(pass.pupil.squaredNorm())));
      sum += weights.back();
    }
    for (double& w : weights) w /= sum;
    return weights;
  }

  /// False where the pixel's chief ray is lost.
  bool trace_pixel(int x, int y, PixelSum& sum, std::vector<Unseen>& unseen) const {
    const auto pixel = static_cast<std::uint32_t>(index(x, y));
    PixelRays rays(field_, {x + 0.5, y + 0.5});
    if (!rays.sight.reaches) return false;
    const auto& set = passes_[set_of(pixel)];
    const auto& weights = weights_[set_of(pixel)];
    UnseenPlaces::Ray packet[lanes];
    float distance[lanes];
    for (int first = 0; first < settings_.passes; first += lanes) {
      const int count = std::min(lanes, settings_.passes - first);
      bent_rays(rays, &set[static_cast<std::size_t>(first)], count, packet);
      first_hits(scene_, packet, count, distance);
      for (int i = 0; i < count; ++i) {
        const auto pass = static_cast<std::size_t>(first + i);
        Unseen found{{x, y, 0, Cell::nowhere}, pixel, static_cast<std::uint32_t>(pass)};
        if (const auto known = looked_up(rays, packet[i], distance[i], found.cell)) {
          sum.radiance += weights[pass] * known->cast<double>();
        } else {
          sum.unseen += weights[pass];
          unseen.push_back(found);
        }
      }
    }
    return true;
  }

  /// An eye that accommodates does so to what each ray's place in the pixel shows at its chief ray.
  void bent_rays(PixelRays& rays, const PupilPass* passes, int count, UnseenPlaces::Ray* packet) const {
    const double a = field_.eye().pupil_radius_m;
    if (!field_.seeks_focus()) {
      rays.bend(field_.slopes(rays.sight, 0.0), a);
      for (int i = 0; i < count; ++i) packet[i] = rays.through(passes[i]);
      return;
    }
    float distance[lanes];
    for (int i = 0; i < count; ++i) packet[i] = rays.chief(passes[i].film);
    first_hits(scene_, packet, count, distance);
    double bent_for = -1.0;
    for (int i = 0; i < count; ++i) {
      const double vergence = 1.0 / static_cast<double>(distance[i]);
      if (!(std::abs(vergence - bent_for) < 1e-3)) rays.bend(field_.slopes(rays.sight, bent_for = vergence), a);
      packet[i] = rays.through(passes[i]);
    }
  }

  std::optional<Vector3f> looked_up(const PixelRays& rays, const UnseenPlaces::Ray& ray, float t, Cell& cell) const {
    constexpr float far_away = 1e6f;  // [m]: a direction as a point; its place is off by a millionth of the pupil
    const bool surroundings = std::isinf(t);
    const Vector3f point = ray.origin + (surroundings ? far_away : t) * ray.direction;
    const auto place = rays.around.place_of(point.cast<double>());
    if (!place || !(place->cwiseAbs().maxCoeff() < 1e6)) return std::nullopt;
    return lookup_.find(*place, point, (point - ray.origin).norm(), surroundings, cell);
  }

  UnseenPlaces::Ray ray_of(const Unseen& u) const {
    const auto w = static_cast<std::uint32_t>(width_);
    PixelRays rays(field_, {u.pixel % w + 0.5, u.pixel / w + 0.5});
    UnseenPlaces::Ray ray;
    bent_rays(rays, &passes_[set_of(u.pixel)][u.pass], 1, &ray);
    return ray;
  }

  const SightField& field_;
  RTCScene scene_;
  PassSettings settings_;
  SharpLookup lookup_;
  int oversampling_, width_, height_;
  std::vector<std::vector<PupilPass>> passes_;  ///< of the 16 pixels of the pattern
  std::vector<std::vector<double>> weights_;    ///< add up to 1 in each set
};

}  // namespace

PassPrediction predict_by_passes(const FragmentImage& view, int oversampling, const SightField& field, RTCScene scene,
                                 const PlaceShader& shade, const PassSettings& settings) {
  const Passes passes(view, oversampling, field, scene, settings);
  PassPrediction result{Image(field.plane().width, field.plane().height, 3), Image(field.plane().width, field.plane().height, 1), {}};
  std::vector<PixelSum> sums;
  const std::vector<Unseen> unseen = passes.trace(sums, result.counters);
  std::vector<std::size_t> begins;
  const UnseenPlaces places = passes.places(unseen, begins);
  result.counters.unseen_places = static_cast<long long>(places.count());
  const std::vector<Vector3f> shaded = places.count() > 0 ? shade(places) : std::vector<Vector3f>{};
  for (std::size_t k = 0; k < begins.size(); ++k)
    for (std::size_t i = begins[k]; i < (k + 1 < begins.size() ? begins[k + 1] : unseen.size()); ++i)
      sums[unseen[i].pixel].radiance += passes.weight_of(unseen[i]) * shaded[k].cast<double>();
  for (std::size_t i = 0; i < sums.size(); ++i) {
    for (int c = 0; c < 3; ++c) result.radiance.pixels[3 * i + static_cast<std::size_t>(c)] = static_cast<float>(sums[i].radiance[c]);
    result.unseen.pixels[i] = static_cast<float>(sums[i].unseen);
  }
  return result;
}

std::vector<UnseenPiece> unseen_pieces(const FragmentImage& view, int oversampling, const SightField& field, RTCScene scene,
                                       const PlaceShader& shade, const PassSettings& settings, PassCounters& counters) {
  const Passes passes(view, oversampling, field, scene, settings);
  std::vector<PixelSum> sums;
  std::vector<Unseen> unseen = passes.trace(sums, counters);
  std::erase_if(unseen, [](const Unseen& u) { return u.cell.kind == Cell::nowhere; });
  std::vector<std::size_t> begins;
  const UnseenPlaces places = passes.places(unseen, begins);
  counters.unseen_places = static_cast<long long>(places.count());
  const std::vector<Vector3f> shaded = places.count() > 0 ? shade(places) : std::vector<Vector3f>{};
  std::vector<UnseenPiece> pieces;
  for (std::size_t k = 0; k < begins.size(); ++k) {
    const Cell& cell = unseen[begins[k]].cell;
    // The middle of the cell's step of distance; what t is along the chief ray differs from it by the blur's obliquity at most.
    const double distance = std::exp((cell.depth + 0.5) / 64.0);
    const auto chief = field.chief_ray(passes.place_of(cell));
    if (!chief) continue;
    const double length = chief->direction.norm();
    pieces.push_back({passes.place_of(cell), cell.depth == Cell::at_infinity ? 0.0 : length / distance, shaded[k]});
  }
  return pieces;
}

}  // namespace sturm
