#include "app/ray_bundle.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "pathtrace/pupil_points.h"

namespace sturm {

namespace {

constexpr std::uint64_t chunk_size = 4096;

/// Angles of the rays through `pupil` (unit disc); those that cannot be launched are left out and counted.
void trace_angles(const EyeRays<double>& rays, double vergence, const std::vector<Eigen::Vector2d>& pupil,
                  std::vector<Eigen::Vector2d>& angles, RayCounters& counters) {
  angles.clear();
  const double radius = rays.pupil_radius();
  for_model(rays.model(), [&](auto model) {
    for (const Eigen::Vector2d& p : pupil) {
      const auto ray = rays.template through_as<model>(radius * p.x(), radius * p.y());
      count(counters, ray.status);
      if (ray.status != LaunchStatus::dropped) angles.push_back({vergence * ray.px + ray.sx, vergence * ray.py + ray.sy});
    }
  });
}

MeasuredBundle measure_replicates(const EyeRays<double>& rays, double vergence, const RayBundleSpec& spec, std::uint64_t seed) {
  const auto replicates = static_cast<std::size_t>(spec.replicates);
  std::vector<BundleMoments> moments(replicates);
  std::vector<RayCounters> counters(replicates);
  tbb::parallel_for(std::size_t{0}, replicates, [&](std::size_t r) {
    std::vector<Eigen::Vector2d> pupil, angles;
    for (std::uint64_t first = 0; first < spec.count; first += chunk_size) {
      pupil.resize(std::min(chunk_size, spec.count - first));
      fill_unit_disk(spec.sequence, seed, static_cast<std::uint32_t>(r), static_cast<std::uint32_t>(first), pupil);
      trace_angles(rays, vergence, pupil, angles, counters[r]);
      moments[r].add(angles);
    }
  });
  MeasuredBundle bundle;
  for (const RayCounters& c : counters) bundle.counters += c;
  if (std::all_of(moments.begin(), moments.end(), [](const BundleMoments& m) { return m.count() >= 2; }))
    bundle.angular = summarise(moments, spec.sequence == Sequence::Sobol ? PointSet::LowDiscrepancy : PointSet::Independent);
  return bundle;
}

MeasuredBundle measure_by_quadrature(const EyeRays<double>& rays, double vergence, const QuadratureSpec& rule) {
  MeasuredBundle bundle;
  std::vector<Eigen::Vector2d> angles;
  std::vector<double> weights;
  const double radius = rays.pupil_radius();
  for (const WeightedPoint& node : disk_quadrature(rule.radial, rule.azimuthal)) {
    const auto ray = rays.through(radius * node.point.x(), radius * node.point.y());
    count(bundle.counters, ray.status);
    if (ray.status == LaunchStatus::dropped) continue;
    angles.push_back({vergence * ray.px + ray.sx, vergence * ray.py + ray.sy});
    weights.push_back(node.weight);
  }
  if (!angles.empty()) bundle.angular = ellipse_of_quadrature(angles, weights);
  return bundle;
}

MeasuredBundle measure_points(const EyeRays<double>& rays, double vergence, const std::vector<Eigen::Vector2d>& points) {
  MeasuredBundle bundle;
  std::vector<Eigen::Vector2d> angles;
  for (const Eigen::Vector2d& p : points) {
    const auto ray = rays.through(p.x(), p.y());
    count(bundle.counters, ray.status);
    if (ray.status != LaunchStatus::dropped) angles.push_back({vergence * ray.px + ray.sx, vergence * ray.py + ray.sy});
  }
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

MeasuredBundle measure_bundle(const EyeRays<double>& rays, double vergence, const RayBundleSpec& spec, std::uint64_t seed) {
  if (!spec.pupil_points_m.empty()) return measure_points(rays, vergence, spec.pupil_points_m);
  if (spec.quadrature) return measure_by_quadrature(rays, vergence, *spec.quadrature);
  return measure_replicates(rays, vergence, spec, seed);
}

}  // namespace sturm
