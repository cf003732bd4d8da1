#include "stages/ray_bundle.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lensmodel/gaze.h"
#include "pathtrace/sampling/pupil_points.h"

namespace sturm {

namespace {

constexpr std::uint64_t chunk_size = 4096;

/// Where the rays go, and what becomes of those that do not arrive.
struct Arrivals {
  double vergence;
  const LensView* lens;
  RayCounters counters;
  LensLosses losses;

  /// The ray's angle at the target; none for a ray that could not be launched or is lost in the lens.
  std::optional<Eigen::Vector2d> angle(const PupilRay<double>& ray) {
    count(counters, ray.status);
    if (ray.status == LaunchStatus::dropped) return std::nullopt;
    if (!lens) return naked_angle(ray, vergence);
    const LensPath path = lens->worn.path_of(ray);
    losses.count(path.status);
    if (path.status != LensStatus::ok) return std::nullopt;
    return lens->angle(path.exit, vergence);
  }
};

/// Angles of the rays through `pupil` (unit disc); those that do not arrive are left out and counted.
void trace_angles(const EyeRays<double>& rays, const std::vector<Eigen::Vector2d>& pupil,
                  std::vector<Eigen::Vector2d>& angles, Arrivals& arrivals) {
  angles.clear();
  const double radius = rays.pupil_radius();
  for_model(rays.model(), [&](auto model) {
    for (const Eigen::Vector2d& p : pupil)
      if (const auto angle = arrivals.angle(rays.template through_as<model>(radius * p.x(), radius * p.y())))
        angles.push_back(*angle);
  });
}

/// First and second moments of weighted rays.
struct WeightedMoments {
  double weight = 0.0;
  std::uint64_t count = 0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();

  void add(const Eigen::Vector2d& angle, double w) {
    weight += w;
    ++count;
    first += w * angle;
    second += w * angle * angle.transpose();
  }
  Eigen::Vector2d mean() const { return first / weight; }
  Eigen::Matrix2d covariance() const { return second / weight - mean() * mean().transpose(); }
};

/// What the replicates of a bundle gathered.
template <class Moments>
struct Replicates {
  std::vector<Moments> moments;
  MeasuredBundle bundle;  ///< counters and losses of all; no ellipse yet
};

/// Runs add_chunk(replicate, first sample, size, moments, arrivals) over the chunks of every replicate, the replicates
/// in parallel.
template <class Moments, class AddChunk>
Replicates<Moments> run_replicates(const RayBundleSpec& spec, const Arrivals& target, const AddChunk& add_chunk) {
  const auto count = static_cast<std::size_t>(spec.replicates);
  Replicates<Moments> result{std::vector<Moments>(count), {}};
  std::vector<Arrivals> arrivals(count, target);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t r) {
    for (std::uint64_t first = 0; first < spec.count; first += chunk_size)
      add_chunk(static_cast<std::uint32_t>(r), static_cast<std::uint32_t>(first),
                std::min(chunk_size, spec.count - first), result.moments[r], arrivals[r]);
  });
  for (const Arrivals& a : arrivals) {
    result.bundle.counters += a.counters;
    result.bundle.losses += a.losses;
  }
  return result;
}

/// Replicates of a pupil whose points have weights.
MeasuredBundle measure_weighted(const EyeRays<double>& rays, const Arrivals& target, const RayBundleSpec& spec,
                                std::uint64_t seed, const PupilSampler& sampler) {
  auto [moments, bundle] = run_replicates<WeightedMoments>(
      spec, target,
      [&](std::uint32_t r, std::uint32_t first, std::uint64_t size, WeightedMoments& sum, Arrivals& arrivals) {
        std::vector<Eigen::Vector2d> pupil(size);
        std::vector<double> weights;
        fill_pupil(sampler, spec.sequence, seed, r, first, pupil, weights);
        for (std::size_t i = 0; i < pupil.size(); ++i) {
          const Eigen::Vector2d p = rays.pupil_radius() * pupil[i];
          if (const auto angle = arrivals.angle(rays.through(p.x(), p.y()))) sum.add(*angle, weights[i]);
        }
      });
  std::vector<ReplicateMoments> replicates;
  for (const WeightedMoments& m : moments) {
    if (m.count < 2 || !(m.weight > 0.0)) return bundle;
    replicates.push_back({m.count, m.mean(), m.covariance()});
  }
  bundle.angular = summarise(replicates);
  return bundle;
}

MeasuredBundle measure_replicates(const EyeRays<double>& rays, const Arrivals& target, const RayBundleSpec& spec,
                                  std::uint64_t seed) {
  auto [moments, bundle] = run_replicates<BundleMoments>(
      spec, target,
      [&](std::uint32_t r, std::uint32_t first, std::uint64_t size, BundleMoments& sum, Arrivals& arrivals) {
        std::vector<Eigen::Vector2d> pupil(size), angles;
        fill_unit_disk(spec.sequence, seed, r, first, pupil);
        trace_angles(rays, pupil, angles, arrivals);
        sum.add(angles);
      });
  if (std::all_of(moments.begin(), moments.end(), [](const BundleMoments& m) { return m.count() >= 2; }))
    bundle.angular =
        summarise(moments, spec.sequence == Sequence::Sobol ? PointSet::LowDiscrepancy : PointSet::Independent);
  return bundle;
}

MeasuredBundle measure_by_quadrature(const EyeRays<double>& rays, Arrivals arrivals, const QuadratureSpec& rule,
                                     double apodization) {
  MeasuredBundle bundle;
  std::vector<Eigen::Vector2d> angles;
  std::vector<double> weights;
  const double radius = rays.pupil_radius();
  for (const WeightedPoint& node : disk_quadrature(rule.radial, rule.azimuthal)) {
    const auto angle = arrivals.angle(rays.through(radius * node.point.x(), radius * node.point.y()));
    if (!angle) continue;
    angles.push_back(*angle);
    weights.push_back(node.weight * std::exp(-apodization * node.point.squaredNorm()));
  }
  bundle.counters = arrivals.counters;
  bundle.losses = arrivals.losses;
  if (!angles.empty()) bundle.angular = ellipse_of_quadrature(angles, weights);
  return bundle;
}

MeasuredBundle measure_points(const EyeRays<double>& rays, Arrivals arrivals,
                              const std::vector<Eigen::Vector2d>& points) {
  MeasuredBundle bundle;
  std::vector<Eigen::Vector2d> angles;
  for (const Eigen::Vector2d& p : points)
    if (const auto angle = arrivals.angle(rays.through(p.x(), p.y()))) angles.push_back(*angle);
  bundle.counters = arrivals.counters;
  bundle.losses = arrivals.losses;
  BundleMoments moments;
  moments.add(angles);
  if (moments.count() >= 2) {
    bundle.angular = summarise(std::span(&moments, 1), PointSet::LowDiscrepancy);  // given points: no standard error
  }
  return bundle;
}

}  // namespace

std::optional<EyeRays<double>> eye_rays_for(RayModel model, const Eye& eye, double accommodation_D) {
  if (!has_rays(model, eye.accommodation)) return std::nullopt;
  return EyeRays<double>(model, eye, accommodation_D,
                         eye.stated_focus_distance_m().value_or(std::numeric_limits<double>::infinity()));
}

void LensLosses::count(LensStatus status) {
  rim += status == LensStatus::missed_lens;
  total_reflection += status == LensStatus::total_internal_reflection;
  no_convergence += status == LensStatus::no_convergence;
}

LensLosses& LensLosses::operator+=(const LensLosses& other) {
  rim += other.rim;
  total_reflection += other.total_reflection;
  no_convergence += other.no_convergence;
  return *this;
}

LensView LensView::along(const Spectacles& lens, const Eigen::Vector3d& gaze, double rotation_center_m) {
  const WornLens worn(lens, gaze, rotation_center_m);
  const LightRay exit = worn.chief_ray().exit;
  const Eigen::Matrix3d across = smallest_rotation({0.0, 0.0, -1.0}, exit.direction);
  return {worn, exit, across.col(0), across.col(1)};
}

Eigen::Vector2d LensView::angle(const LightRay& ray, double vergence_D) const {
  // x = w + s N, w from the exit point, with x·chief = d: x⊥/d = w⊥/d + (1 − w·chief/d) N⊥/(N·chief).
  const Eigen::Vector3d w = ray.origin - chief.origin;
  const double along = (1.0 - vergence_D * w.dot(chief.direction)) / ray.direction.dot(chief.direction);
  const Eigen::Vector3d offset = vergence_D * w + along * ray.direction;
  return {offset.dot(e1), offset.dot(e2)};
}

MeasuredBundle measure_bundle(const EyeRays<double>& rays, double vergence, const RayBundleSpec& spec,
                              std::uint64_t seed, const LensView* lens, double apodization) {
  const Arrivals target{vergence, lens, {}, {}};
  if (!spec.pupil_points_m.empty()) return measure_points(rays, target, spec.pupil_points_m);
  if (spec.quadrature) return measure_by_quadrature(rays, target, *spec.quadrature, apodization);
  const PupilSampler sampler(spec.sampling, apodization);
  if (!sampler.is_uniform()) return measure_weighted(rays, target, spec, seed, sampler);
  return measure_replicates(rays, target, spec, seed);
}

}  // namespace sturm
