#include "app/ray_bundle.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "pathtrace/pupil_points.h"

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
    if (!lens) return Eigen::Vector2d(vergence * ray.px + ray.sx, vergence * ray.py + ray.sy);
    const LensPath path = lens->worn.path_of(ray);
    losses.count(path.status);
    if (path.status != LensStatus::ok) return std::nullopt;
    return lens->angle(path.exit, vergence);
  }
};

/// Angles of the rays through `pupil` (unit disc); those that do not arrive are left out and counted.
void trace_angles(const EyeRays<double>& rays, const std::vector<Eigen::Vector2d>& pupil, std::vector<Eigen::Vector2d>& angles,
                  Arrivals& arrivals) {
  angles.clear();
  const double radius = rays.pupil_radius();
  for_model(rays.model(), [&](auto model) {
    for (const Eigen::Vector2d& p : pupil)
      if (const auto angle = arrivals.angle(rays.template through_as<model>(radius * p.x(), radius * p.y()))) angles.push_back(*angle);
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

/// As summarise() does for unweighted rays: standard errors are the scatter between the replicates divided by √R; one has none.
BundleEllipse summarise_weighted(const std::vector<WeightedMoments>& replicates) {
  BundleEllipse e;
  const double n = static_cast<double>(replicates.size());
  e.replicates = static_cast<int>(replicates.size());
  for (const WeightedMoments& m : replicates) {
    e.points += m.count;
    e.centroid += m.mean() / n;
    e.covariance += m.covariance() / n;
  }
  e.ellipse = Ellipse::of_second_moments(e.covariance);
  if (replicates.size() < 2) return e;
  e.degrees_of_freedom = n - 1.0;
  Eigen::Vector2d centroid_squares = Eigen::Vector2d::Zero();
  Eigen::Matrix3d entries = Eigen::Matrix3d::Zero();
  for (const WeightedMoments& m : replicates) {
    centroid_squares += (m.mean() - e.centroid).cwiseAbs2();
    const Eigen::Matrix2d d = m.covariance() - e.covariance;
    const Eigen::Vector3d entry(d(0, 0), d(0, 1), d(1, 1));
    entries += entry * entry.transpose();
  }
  e.centroid_standard_error = (centroid_squares / (n * (n - 1.0))).cwiseSqrt();
  e.entry_covariance = entries / (n * (n - 1.0));
  return e;
}

/// Replicates of a pupil whose points have weights.
MeasuredBundle measure_weighted(const EyeRays<double>& rays, const Arrivals& target, const RayBundleSpec& spec, std::uint64_t seed,
                                const PupilSampler& sampler) {
  const auto replicates = static_cast<std::size_t>(spec.replicates);
  std::vector<WeightedMoments> moments(replicates);
  std::vector<Arrivals> arrivals(replicates, target);
  tbb::parallel_for(std::size_t{0}, replicates, [&](std::size_t r) {
    std::vector<Eigen::Vector2d> pupil;
    std::vector<double> weights;
    for (std::uint64_t first = 0; first < spec.count; first += chunk_size) {
      pupil.resize(std::min(chunk_size, spec.count - first));
      fill_pupil(sampler, spec.sequence, seed, static_cast<std::uint32_t>(r), static_cast<std::uint32_t>(first), pupil, weights);
      for (std::size_t i = 0; i < pupil.size(); ++i) {
        const Eigen::Vector2d p = rays.pupil_radius() * pupil[i];
        if (const auto angle = arrivals[r].angle(rays.through(p.x(), p.y()))) moments[r].add(*angle, weights[i]);
      }
    }
  });
  MeasuredBundle bundle;
  for (const Arrivals& a : arrivals) {
    bundle.counters += a.counters;
    bundle.losses += a.losses;
  }
  if (std::all_of(moments.begin(), moments.end(), [](const WeightedMoments& m) { return m.count >= 2 && m.weight > 0.0; }))
    bundle.angular = summarise_weighted(moments);
  return bundle;
}

MeasuredBundle measure_replicates(const EyeRays<double>& rays, const Arrivals& target, const RayBundleSpec& spec, std::uint64_t seed) {
  const auto replicates = static_cast<std::size_t>(spec.replicates);
  std::vector<BundleMoments> moments(replicates);
  std::vector<Arrivals> arrivals(replicates, target);
  tbb::parallel_for(std::size_t{0}, replicates, [&](std::size_t r) {
    std::vector<Eigen::Vector2d> pupil, angles;
    for (std::uint64_t first = 0; first < spec.count; first += chunk_size) {
      pupil.resize(std::min(chunk_size, spec.count - first));
      fill_unit_disk(spec.sequence, seed, static_cast<std::uint32_t>(r), static_cast<std::uint32_t>(first), pupil);
      trace_angles(rays, pupil, angles, arrivals[r]);
      moments[r].add(angles);
    }
  });
  MeasuredBundle bundle;
  for (const Arrivals& a : arrivals) {
    bundle.counters += a.counters;
    bundle.losses += a.losses;
  }
  if (std::all_of(moments.begin(), moments.end(), [](const BundleMoments& m) { return m.count() >= 2; }))
    bundle.angular = summarise(moments, spec.sequence == Sequence::Sobol ? PointSet::LowDiscrepancy : PointSet::Independent);
  return bundle;
}

MeasuredBundle measure_by_quadrature(const EyeRays<double>& rays, Arrivals arrivals, const QuadratureSpec& rule, double apodization) {
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

MeasuredBundle measure_points(const EyeRays<double>& rays, Arrivals arrivals, const std::vector<Eigen::Vector2d>& points) {
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
  if (model != RayModel::metalstigmatism) return EyeRays<double>(model, eye, accommodation_D);
  const auto focus = eye.stated_focus_distance_m();
  if (!focus) return std::nullopt;
  return EyeRays<double>(model, eye, accommodation_D, *focus);
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

Eigen::Vector2d LensView::angle(const LightRay& ray, double vergence_D) const {
  // x = w + s N, w from the exit point, with x·chief = d: x⊥/d = w⊥/d + (1 − w·chief/d) N⊥/(N·chief).
  const Eigen::Vector3d w = ray.origin - chief.origin;
  const double along = (1.0 - vergence_D * w.dot(chief.direction)) / ray.direction.dot(chief.direction);
  const Eigen::Vector3d offset = vergence_D * w + along * ray.direction;
  return {offset.dot(e1), offset.dot(e2)};
}

MeasuredBundle measure_bundle(const EyeRays<double>& rays, double vergence, const RayBundleSpec& spec, std::uint64_t seed,
                              const LensView* lens, double apodization) {
  const Arrivals target{vergence, lens, {}, {}};
  if (!spec.pupil_points_m.empty()) return measure_points(rays, target, spec.pupil_points_m);
  if (spec.quadrature) return measure_by_quadrature(rays, target, *spec.quadrature, apodization);
  const PupilSampler sampler(spec.sampling, apodization);
  if (!sampler.is_uniform()) return measure_weighted(rays, target, spec, seed, sampler);
  return measure_replicates(rays, target, spec, seed);
}

}  // namespace sturm
