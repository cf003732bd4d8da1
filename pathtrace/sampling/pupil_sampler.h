#pragma once
#include <Eigen/Core>
#include <vector>

#include "io/specs/pupil_sampling_spec.h"

namespace sturm {

/// A point of the unit disc and its share of the pupil's light.
struct WeightedPoint {
  Eigen::Vector2d point;
  double weight;
};

/// Spreads points over the pupil and weights them: sampling and Stiles–Crawford apodization
/// (docs/theory.md#53-pupil-sampling). Immutable.
class PupilSampler {
 public:
  /// Uniform, without apodization.
  PupilSampler() : PupilSampler(PupilSamplingSpec{}, 0.0) {}

  /// `apodization` is q = ρ ln 10 · a² ≥ 0 for the Stiles–Crawford weight 10^(−ρ r²); 0 is none. A uniform disc is
  /// apodized by its density (weights 1), the other samplings by weights.
  PupilSampler(const PupilSamplingSpec& spec, double apodization);

  /// True where every point has the weight 1.
  bool unweighted() const;

  /// True for a uniform pupil without apodization.
  bool is_uniform() const { return spec_.kind == PupilSampling::UniformDisk && apodization_ == 0.0; }

  /// The point for (u, v) in [0, 1)². Weights have the mean 1 over the unit square.
  WeightedPoint at(double u, double v) const;

  /// False for points that stand in fixed places.
  bool has_density() const { return spec_.kind != PupilSampling::Rings; }

  /// How densely `at` spreads its points, per area of the unit disc, and the weight that it gives to one there. Needs
  /// `has_density`. `uniform_polar` is infinitely dense at the centre.
  double density(const Eigen::Vector2d& point) const;
  double weight(const Eigen::Vector2d& point) const;

 private:
  PupilSamplingSpec spec_;
  double apodization_;
  double mean_weight_ = 1.0;            // of the raw weights
  std::vector<Eigen::Vector2d> rings_;  // all points of the rings
};

/// q of an eye with the Stiles–Crawford parameter `rho_per_m2` (0.05 mm⁻² = 5e4 m⁻²) and the pupil radius [m].
double apodization_of(double rho_per_m2, double pupil_radius_m);

}  // namespace sturm
