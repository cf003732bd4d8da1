#include "experiments/sin2_study/pupil_trace.h"

#include "lensmodel/units.h"
#include "stages/ray_bundle.h"

namespace sturm {

namespace {

void normalise(std::vector<WeightedPoint>& points) {
  double sum = 0.0;
  for (const WeightedPoint& p : points) sum += p.weight;
  for (WeightedPoint& p : points) p.weight /= sum;
}

/// Each point drawn once, in the middle of its share of the unit interval.
std::vector<WeightedPoint> points_of_rings(const PupilSamplingSpec& spec) {
  const PupilSampler sampler(spec, 0.0);
  const int count = spec.angle_factor * spec.rings * (spec.rings + 1) / 2;
  std::vector<WeightedPoint> points;
  for (int i = 0; i < count; ++i) points.push_back({sampler.at((i + 0.5) / count, 0.0).point, 1.0});
  normalise(points);
  return points;
}

}  // namespace

StudyPupils::StudyPupils(const Sin2StudySpec& spec)
    : uniform_disk(disk_quadrature(spec.quadrature.radial, spec.quadrature.azimuthal)),
      every_second(disk_quadrature(spec.quadrature.radial, spec.quadrature.azimuthal / 2)),
      polar(uniform_disk),
      rings(points_of_rings(spec.rings)) {
  // The rule's nodes are Gauss–Legendre in t = r²; a uniform radius takes the same nodes for r = t.
  for (WeightedPoint& p : polar) p.point *= p.point.norm();
  polar_weighted = polar;
  for (WeightedPoint& p : polar_weighted) p.weight *= 2.0 * p.point.norm();
  normalise(polar_weighted);
}

TangentialTerm::TangentialTerm(const PowerMatrix& correction) {
  const Prescription rx = correction.as_prescription();
  const SineCosine axis = sine_cosine_of_degrees(180.0 - rx.axis_deg);
  cylinder_D_ = rx.cylinder_D;
  cosine_ = axis.cosine;
  sine_ = axis.sine;
}

void TangentialTerm::add_to(PupilRay<double>& ray) const {
  const double square = ray.px * ray.px + ray.py * ray.py;
  if (square == 0.0) return;
  const double across = ray.py * cosine_ - ray.px * sine_,
               along = ray.px * cosine_ + ray.py * sine_;  // r sin, r cos of φ − α
  const double term = cylinder_D_ * across * along / square;
  ray.sx -= term * ray.py;
  ray.sy += term * ray.px;
}

TracedPupil traced(const EyeRays<double>& rays, std::span<const WeightedPoint> pupil, double target_vergence_D,
                   const TangentialTerm* added) {
  TracedPupil result;
  double weight = 0.0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  const double radius = rays.pupil_radius();
  for_model(rays.model(), [&](auto model) {
    for (const WeightedPoint& node : pupil) {
      PupilRay<double> ray = rays.template through_as<model>(radius * node.point.x(), radius * node.point.y());
      count(result.counters, ray.status);
      if (!goes_on(ray.status)) continue;
      if (added) added->add_to(ray);
      const Eigen::Vector2d angle = naked_angle(ray, target_vergence_D);
      weight += node.weight;
      first += node.weight * angle;
      second += node.weight * angle * angle.transpose();
    }
  });
  if (weight > 0.0) result.covariance = second / weight - first * first.transpose() / (weight * weight);
  return result;
}

}  // namespace sturm
