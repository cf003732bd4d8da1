#include "conoid/pictures/multipass.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "conoid/pictures/lamp_reach.h"
#include "conoid/pictures/pixel_rays.h"
#include "conoid/pictures/pupil_passes.h"
#include "conoid/pictures/sharp_lookup.h"
#include "conoid/threads/parallel_for.h"

namespace sturm {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

/// The most that one ray which meets a lamp may be of what its pixel has: beyond it, the lamp's rim shows steps. Of
/// very bright lamps much more would take too many rays, so that their many passes are left alone sooner.
constexpr double coarsest_step = 1.0 / 32.0, coarsest_step_of_many = 0.25;

/// Pixels that are darker than this part of the picture's middle brightness count as that bright: in black letters on a
/// screen no number of passes would be enough.
constexpr float darkest_share = 1.0f / 16.0f;

/// So many rays are sent into the scene together.
constexpr int packet_size = 8;

/// One ray that met what the sharp view does not show.
struct Unseen {
  UnseenCell cell;
  std::uint32_t pixel;
  std::uint32_t pass;  ///< counted through all stages
  auto operator<=>(const Unseen&) const = default;
};

struct PixelSum {
  Vector3d radiance{0.0, 0.0, 0.0};
  double unseen = 0.0;
};

/// Interleaved passes with their weights, which add up to 1 in each of the 16 sets. Made when they are first asked for.
class PassSets {
 public:
  PassSets(int count, std::uint32_t first, const Eye& eye) : count_(count), first_(first), eye_(eye) {}

  int count() const { return count_; }
  std::uint32_t first() const { return first_; }  ///< pass of all stages
  std::uint32_t end() const { return first_ + static_cast<std::uint32_t>(count_); }

  const std::vector<PupilPass>& points(std::size_t set) const { return made().points[set]; }
  const std::vector<double>& weights(std::size_t set) const { return made().weights[set]; }

 private:
  struct Made {
    std::vector<std::vector<PupilPass>> points;
    std::vector<std::vector<double>> weights;
  };

  const Made& made() const {
    std::call_once(once_, [this] {
      const double a = eye_.pupil_radius_m;
      made_.points = interleaved_passes(count_);
      for (const auto& set : made_.points) {
        std::vector<double>& of_set = made_.weights.emplace_back();
        double sum = 0.0;
        for (const PupilPass& pass : set)
          sum += of_set.emplace_back(
              std::pow(10.0, -eye_.stiles_crawford_per_m2 * a * a * static_cast<double>(pass.pupil.squaredNorm())));
        for (double& w : of_set) w /= sum;
      }
    });
    return made_;
  }

  int count_;
  std::uint32_t first_;
  const Eye& eye_;
  mutable std::once_flag once_;
  mutable Made made_;
};

/// Logarithmic mean over sharp pixels of their brightest channel, which tone mapping takes for the middle [Reinhard et
/// al. 2002, eq. 1]; nothing counts as darker than a millionth of the brightest. 0 if all is black.
float middle_brightness(const FragmentImage& view) {
  std::vector<double> brightness;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      Vector3f sum = Vector3f::Zero();
      for (const Fragment& f : view.at(x, y)) sum += f.share * f.radiance;
      brightness.push_back(static_cast<double>(sum.maxCoeff()));
    }
  const double black = 1e-6 * *std::max_element(brightness.begin(), brightness.end());
  double logarithms = 0.0;
  for (const double b : brightness) logarithms += std::log(std::max(b, black));
  return static_cast<float>(std::exp(logarithms / static_cast<double>(brightness.size())));
}

class Passes {
 public:
  Passes(const FragmentImage& view, int oversampling, const SightField& field, const FirstHits& first_hits,
         const PassSettings& settings, bool tell_lamps)
      : field_(field),
        first_hits_(first_hits),
        settings_(settings),
        lookup_(view, oversampling, field.plane().pixel_slope, tell_lamps),
        oversampling_(oversampling),
        width_(field.plane().width),
        height_(field.plane().height),
        everywhere_(settings.passes, 0, field.eye()),
        at_lamps_(settings.passes * settings.lamp_factor, everywhere_.end(), field.eye()),
        at_bright_lamps_(at_lamps_.count() * settings.lamp_factor, at_lamps_.end(), field.eye()) {
    if (view.width != width_ * oversampling || view.height != height_ * oversampling)
      throw std::invalid_argument("passes: the sharp view does not cover the picture");
    if (settings.passes < 1 || settings.rays_per_place < 1 || settings.lamp_factor < 1)
      throw std::invalid_argument("passes: expected at least one");
    if (settings.lamp_factor == 1) return;
    lamps_ = lamp_reach(view, oversampling, field);
    darkest_ = static_cast<double>(darkest_share * middle_brightness(view));
  }

  /// Sends all rays. `sums` gets what the sharp view knows, one entry per pixel; the result is what it does not know,
  /// sorted.
  std::vector<Unseen> trace(std::vector<PixelSum>& sums, PassCounters& counters) const {
    sums.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), {});
    std::vector<std::vector<Unseen>> rows(static_cast<std::size_t>(height_));
    std::vector<PassCounters> counted(rows.size());
    parallel_for(0, height_, [&](int y) {
      const auto row = static_cast<std::size_t>(y);
      for (int x = 0; x < width_; ++x) trace_pixel(x, y, sums[index(x, y)], rows[row], counted[row]);
    });
    std::vector<Unseen> all;
    for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
    tbb::parallel_sort(all.begin(), all.end());
    for (const PassCounters& row : counted) {
      counters.rays += row.rays;
      counters.lost_pixels += row.lost_pixels;
      counters.lamp_pixels += row.lamp_pixels;
      counters.bright_lamp_pixels += row.bright_lamp_pixels;
    }
    counters.unseen_rays = static_cast<long long>(all.size());
    return all;
  }

  /// The places of sorted rays, with up to rays_per_place of each, evenly chosen; `begins` gets where each place begins
  /// in `unseen`.
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
    parallel_for(std::size_t{0}, chosen.size(), [&](std::size_t i) { result.rays[i] = ray_of(*chosen[i]); });
    return result;
  }

  double weight_of(const Unseen& u) const {
    const PassSets& stage = stage_of(u.pass);
    return stage.weights(set_of(u.pixel))[u.pass - stage.first()];
  }
  /// The part of its sharp pixel that a lamp fills at about this distance, whatever stands before it.
  float lamp_share(const UnseenCell& cell) const {
    constexpr int rows = 16;
    const auto depth = static_cast<float>(cell.distance());
    const float nearest = 0.97f * depth, farthest = 1.03f * depth;  // twice the step of a cell's distance either way
    static_assert(rows % packet_size == 0);
    int met = 0;
    for (int k = 0; k < rows * rows; k += packet_size) {
      SeenRay rays[packet_size];
      FirstHit hits[packet_size];
      int count = 0;
      for (int lane = 0; lane < packet_size; ++lane) {
        const Vector2d within(((k + lane) % rows + 0.5) / rows, ((k + lane) / rows + 0.5) / rows);
        const auto chief = field_.chief_ray((Vector2d(cell.x, cell.y) + within) / oversampling_);
        if (chief) rays[count++] = {chief->origin.cast<float>(), chief->direction.cast<float>()};
      }
      find_hits(rays, hits, count, nearest);
      for (int i = 0; i < count; ++i)
        if (hits[i].emits && hits[i].distance * rays[i].direction.norm() <= farthest) ++met;
    }
    return static_cast<float>(met) / static_cast<float>(rows * rows);
  }

  Vector2d place_of(const UnseenCell& cell) const {
    return {(cell.x + 0.5) / oversampling_, (cell.y + 0.5) / oversampling_};
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  std::size_t set_of(std::uint32_t pixel) const {
    const std::uint32_t x = pixel % static_cast<std::uint32_t>(width_), y = pixel / static_cast<std::uint32_t>(width_);
    return y % 4 * 4 + x % 4;
  }

  const PassSets& stage_of(std::uint32_t pass) const {
    return pass < everywhere_.end() ? everywhere_ : pass < at_lamps_.end() ? at_lamps_ : at_bright_lamps_;
  }

  void trace_pixel(int x, int y, PixelSum& sum, std::vector<Unseen>& unseen, PassCounters& counters) const {
    const auto pixel = static_cast<std::uint32_t>(index(x, y));
    PixelRays rays(field_, {x + 0.5, y + 0.5});
    if (!rays.sight.reaches) {
      ++counters.lost_pixels;
      return;
    }
    if (!field_.seeks_focus()) rays.bend(0.0);
    const std::size_t before = unseen.size();
    const auto send_all = [&](const PassSets& stage) {
      unseen.resize(before);
      sum = {};
      send(stage, rays, pixel, sum, unseen);
      counters.rays += stage.count();
    };
    const double lamp = settings_.lamp_factor > 1 ? static_cast<double>(*lamps_.at(x, y)) : 0.0;
    const auto shows_steps = [&](const PassSets& stage, double coarsest) {
      return lamp > coarsest * stage.count() * std::max(sum.radiance.maxCoeff(), darkest_);
    };
    send_all(everywhere_);
    if (!shows_steps(everywhere_, coarsest_step)) return;
    send_all(at_lamps_);
    ++counters.lamp_pixels;
    if (!shows_steps(at_lamps_, coarsest_step_of_many)) return;
    send_all(at_bright_lamps_);
    ++counters.bright_lamp_pixels;
  }

  void send(const PassSets& stage, PixelRays& rays, std::uint32_t pixel, PixelSum& sum,
            std::vector<Unseen>& unseen) const {
    const auto& points = stage.points(set_of(pixel));
    const auto& weights = stage.weights(set_of(pixel));
    SeenRay bent[packet_size];
    FirstHit hits[packet_size];
    for (std::size_t first = 0; first < points.size(); first += packet_size) {
      const int count = static_cast<int>(std::min<std::size_t>(packet_size, points.size() - first));
      bent_rays(rays, &points[first], count, bent);
      find_hits(bent, hits, count);
      for (int i = 0; i < count; ++i) {
        const std::size_t pass = first + static_cast<std::size_t>(i);
        UnseenCell cell{static_cast<std::int32_t>(pixel % static_cast<std::uint32_t>(width_)),
                        static_cast<std::int32_t>(pixel / static_cast<std::uint32_t>(width_)), 0, UnseenCell::nowhere};
        if (const auto known = looked_up(rays, bent[i], hits[i], cell)) {
          sum.radiance += weights[pass] * known->cast<double>();
        } else {
          sum.unseen += weights[pass];
          unseen.push_back({cell, pixel, stage.first() + static_cast<std::uint32_t>(pass)});
        }
      }
    }
  }

  /// The first `count` rays of a packet.
  void find_hits(const SeenRay* rays, FirstHit* hits, int count, float from_m = 0.0f) const {
    const auto size = static_cast<std::size_t>(count);
    first_hits_({rays, size}, from_m, {hits, size});
  }

  /// An eye that accommodates does so to what each ray's place in the pixel shows at its chief ray.
  void bent_rays(PixelRays& rays, const PupilPass* passes, int count, SeenRay* bent) const {
    if (!field_.seeks_focus()) {
      for (int i = 0; i < count; ++i) bent[i] = rays.through(passes[i]);
      return;
    }
    FirstHit hits[packet_size];
    for (int i = 0; i < count; ++i) bent[i] = rays.chief(passes[i].film);
    find_hits(bent, hits, count);
    for (int i = 0; i < count; ++i) {
      rays.bend(1.0 / static_cast<double>(hits[i].distance));
      bent[i] = rays.through(passes[i]);
    }
  }

  std::optional<Vector3f> looked_up(const PixelRays& rays, const SeenRay& ray, const FirstHit& hit,
                                    UnseenCell& cell) const {
    constexpr float far_away = 1e6f;  // [m]: a direction as a point; its place is off by a millionth of the pupil
    const float t = hit.distance;
    const bool surroundings = std::isinf(t);
    const Vector3f along = (surroundings ? far_away : t) * ray.direction, position = ray.origin + along;
    const auto place = rays.around.place_of(position.cast<double>());
    if (!place || !(place->cwiseAbs().maxCoeff() < 1e6)) return std::nullopt;
    const MetPoint point{*place, position, along.norm(), surroundings, hit.emits};
    const auto known = lookup_.find(point);
    if (!known) cell = lookup_.cell_of(point);
    return known;
  }

  SeenRay ray_of(const Unseen& u) const {
    const auto w = static_cast<std::uint32_t>(width_);
    PixelRays rays(field_, {u.pixel % w + 0.5, u.pixel / w + 0.5});
    if (!field_.seeks_focus()) rays.bend(0.0);
    const PassSets& stage = stage_of(u.pass);
    SeenRay ray;
    bent_rays(rays, &stage.points(set_of(u.pixel))[u.pass - stage.first()], 1, &ray);
    return ray;
  }

  const SightField& field_;
  const FirstHits& first_hits_;
  PassSettings settings_;
  SharpLookup lookup_;
  int oversampling_, width_, height_;
  PassSets everywhere_, at_lamps_, at_bright_lamps_;
  Image lamps_;           ///< lamp_reach; empty without passes for lamps
  double darkest_ = 0.0;  ///< radiance below which a pixel counts as this bright
};

}  // namespace

PassPrediction predict_by_passes(const FragmentImage& view, int oversampling, const SightField& field,
                                 const FirstHits& first_hits, const PlaceShader& shade, const PassSettings& settings) {
  const Passes passes(view, oversampling, field, first_hits, settings, true);
  PassPrediction result{
      Image(field.plane().width, field.plane().height, 3), Image(field.plane().width, field.plane().height, 1), {}};
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
    for (int c = 0; c < 3; ++c)
      result.radiance.pixels[3 * i + static_cast<std::size_t>(c)] = static_cast<float>(sums[i].radiance[c]);
    result.unseen.pixels[i] = static_cast<float>(sums[i].unseen);
  }
  return result;
}

std::vector<UnseenPiece> unseen_pieces(const FragmentImage& view, int oversampling, const SightField& field,
                                       const FirstHits& first_hits, const PlaceShader& shade,
                                       const PassSettings& settings, PassCounters& counters) {
  PassSettings everywhere = settings;
  everywhere.lamp_factor = 1;
  const Passes passes(view, oversampling, field, first_hits, everywhere, false);
  std::vector<PixelSum> sums;
  std::vector<Unseen> unseen = passes.trace(sums, counters);
  std::erase_if(unseen, [](const Unseen& u) { return u.cell.kind == UnseenCell::nowhere; });
  std::vector<std::size_t> begins;
  const UnseenPlaces places = passes.places(unseen, begins);
  counters.unseen_places = static_cast<long long>(places.count());
  const std::vector<Vector3f> shaded = places.count() > 0 ? shade(places) : std::vector<Vector3f>{};
  std::vector<UnseenPiece> pieces;
  for (std::size_t k = 0; k < begins.size(); ++k) {
    const UnseenCell& cell = unseen[begins[k]].cell;
    const auto chief = field.chief_ray(passes.place_of(cell));
    if (!chief) continue;
    // The rays that found a lamp are those that met it, so that they cannot tell how much of the pixel it is.
    const float share = cell.kind == UnseenCell::lamp ? passes.lamp_share(cell) : 1.0f;
    // What t is along the chief ray differs from the distance by the blur's obliquity at most.
    if (share > 0.0f)
      pieces.push_back({passes.place_of(cell), chief->direction.norm() / cell.distance(), shaded[k], share});
  }
  return pieces;
}

}  // namespace sturm
