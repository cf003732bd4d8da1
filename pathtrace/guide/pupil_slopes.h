#pragma once
#include <Eigen/Core>

#include "pathtrace/cameras/ray_model.h"

namespace sturm {

/// Slopes over the pupil as nearly as an affine map says them: s(p) ≈ constant + matrix·p.
struct PupilSlopes {
  Eigen::Vector2d constant = Eigen::Vector2d::Zero();
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();  ///< [D]
  double residual = 0.0;                             ///< largest distance of a ray's slope from it, by 576 rays [rad]
};

/// The least-squares map of any ray model over a uniform pupil; of `power_matrix` and `thin_lens` exact. Rays that the
/// model drops count as straight.
PupilSlopes fitted_slopes(const EyeRays<double>& rays);

}  // namespace sturm
