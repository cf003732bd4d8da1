#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "io/specs/experiment/sin2_study_spec.h"
#include "pathtrace/cameras/ray_model.h"
#include "pathtrace/sampling/pupil_points.h"

namespace sturm {

/// The pupil points of the study, by sampling (unit disc, weights that add up to 1). The radii of uniform_polar are
/// Gauss–Legendre nodes in r itself, so these are the expectations of the samplings, without noise; rings are the very
/// points.
struct StudyPupils {
  std::vector<WeightedPoint> uniform_disk,
      every_second;  ///< the second with half as many angles, which shows how well they resolve
  std::vector<WeightedPoint> polar, polar_weighted, rings;

  explicit StudyPupils(const Sin2StudySpec& spec);
};

/// The part of the wavefront's slope that sin² interpolation drops
/// (docs/theory.md#6-sine-squared-interpolation-against-wavefront-theory): r·C sin(φ − α) cos(φ − α) along e_φ, from
/// the prescription's own numbers at the cornea (Euler's theorem: W = −½ r² P(φ), so the tangential slope is ½ r
/// dP/dφ).
class TangentialTerm {
 public:
  explicit TangentialTerm(const PowerMatrix& correction);

  void add_to(PupilRay<double>& ray) const;

 private:
  double cylinder_D_, cosine_, sine_;  // of the axis in the wearer frame
};

/// What became of the rays through a pupil.
struct TracedPupil {
  std::optional<Eigen::Matrix2d> covariance;  ///< of the angles at the target [rad²]; none if no ray was launched
  RayCounters counters;
};

/// Traces the rays of a naked eye through `pupil` to a target of vergence 1/d [D]; with `added`, each gets the
/// tangential term.
TracedPupil traced(const EyeRays<double>& rays, std::span<const WeightedPoint> pupil, double target_vergence_D,
                   const TangentialTerm* added = nullptr);

}  // namespace sturm
