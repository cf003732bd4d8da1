#include "pathtrace/sampling/pupil_sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pathtrace/sampling/disk.h"

namespace sturm {

namespace {

std::vector<Eigen::Vector2d> ring_points(int rings, int angle_factor) {
  std::vector<Eigen::Vector2d> points;
  for (int k = 1; k <= rings; ++k)
    for (int j = 0; j < angle_factor * k; ++j) {
      const double angle = 2.0 * std::numbers::pi * j / (angle_factor * k), radius = static_cast<double>(k) / rings;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
  return points;
}

/// Mean of exp(−q r²) over a uniform disc.
double mean_over_disc(double q) {
  return q > 0.0 ? -std::expm1(-q) / q : 1.0;
}

/// Mean of exp(−q r²) over a uniform radius.
double mean_over_radius(double q) {
  return q > 0.0 ? 0.5 * std::sqrt(std::numbers::pi / q) * std::erf(std::sqrt(q)) : 1.0;
}

}  // namespace

PupilSampler::PupilSampler(const PupilSamplingSpec& spec, double apodization) : spec_(spec), apodization_(apodization) {
  switch (spec.kind) {
    case PupilSampling::UniformDisk:
      break;
    case PupilSampling::UniformPolar:
      mean_weight_ = mean_over_radius(apodization);
      break;
    case PupilSampling::UniformPolarWeighted:
      mean_weight_ = mean_over_disc(apodization);
      break;
    case PupilSampling::Rings:
      rings_ = ring_points(spec.rings, spec.angle_factor);
      mean_weight_ = 0.0;
      for (const Eigen::Vector2d& p : rings_)
        mean_weight_ += std::exp(-apodization * p.squaredNorm()) / static_cast<double>(rings_.size());
  }
}

bool PupilSampler::unweighted() const {
  return spec_.kind == PupilSampling::UniformDisk ||
         (apodization_ == 0.0 && spec_.kind != PupilSampling::UniformPolarWeighted);
}

WeightedPoint PupilSampler::at(double u, double v) const {
  if (spec_.kind == PupilSampling::UniformDisk) {
    const auto d = concentric_disk(u, v);
    const Eigen::Vector2d point(d.x, d.y);
    if (apodization_ == 0.0) return {point, 1.0};
    // The share of a uniform disc within r is r²; of the apodized one (1 − e^(−q r²))/(1 − e^−q). Equal shares:
    const double square = point.squaredNorm();
    if (square == 0.0) return {point, 1.0};
    const double moved = std::min(1.0, -std::log1p(square * std::expm1(-apodization_)) / apodization_);
    return {std::sqrt(moved / square) * point, 1.0};
  }
  Eigen::Vector2d point;
  double weight = 1.0;
  if (spec_.kind == PupilSampling::Rings) {
    const auto count = static_cast<double>(rings_.size());
    point = rings_[std::min(rings_.size() - 1, static_cast<std::size_t>(u * count))];
  } else {
    const double angle = 2.0 * std::numbers::pi * v;
    point = {u * std::cos(angle), u * std::sin(angle)};
    if (spec_.kind == PupilSampling::UniformPolarWeighted) weight = 2.0 * u;
  }
  return {point, weight * std::exp(-apodization_ * point.squaredNorm()) / mean_weight_};
}

double PupilSampler::density(const Eigen::Vector2d& point) const {
  if (spec_.kind != PupilSampling::UniformDisk) return 1.0 / (2.0 * std::numbers::pi * point.norm());
  // mean_over_disc: the mean of e^(−q r²) over the disc, so that the density integrates to 1.
  return std::exp(-apodization_ * point.squaredNorm()) / (std::numbers::pi * mean_over_disc(apodization_));
}

double PupilSampler::weight(const Eigen::Vector2d& point) const {
  if (spec_.kind == PupilSampling::UniformDisk) return 1.0;
  const double spread = spec_.kind == PupilSampling::UniformPolarWeighted ? 2.0 * point.norm() : 1.0;
  return spread * std::exp(-apodization_ * point.squaredNorm()) / mean_weight_;
}

double apodization_of(double rho_per_m2, double pupil_radius_m) {
  return rho_per_m2 * std::numbers::ln10 * pupil_radius_m * pupil_radius_m;
}

}  // namespace sturm
