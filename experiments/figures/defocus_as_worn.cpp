#include "experiments/figures/defocus_as_worn.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "conoid/tracing/spectacle_conoid.h"
#include "lensmodel/symmetric2.h"
#include "lensmodel/units.h"

namespace sturm {

std::optional<DefocusAsWorn> defocus_as_worn(const Spectacles& lens, const PowerMatrix& correction,
                                             const Eigen::Vector3d& gaze, double rotation_center_m, double distance_m,
                                             double amplitude_D) {
  const double vergence = vergence_of(distance_m);
  const SpectacleConoid conoid = trace_conoid(lens, gaze, rotation_center_m);
  if (conoid.status != LensStatus::ok) return std::nullopt;
  const Eigen::Matrix2d q = conoid.angular_q(vergence);
  if (!(singular_values(q).small > SpectacleConoid::relative_singularity * singular_values(q).large))
    return std::nullopt;
  // Slopes of the rays that come from one point of the target: P + Q S = 0.
  const Eigen::Matrix2d present = -q.inverse() * conoid.angular_p(vergence);
  const Eigen::Matrix2d excess = present - correction.matrix();
  const double relaxed = 0.5 * excess.trace(), mean = relaxed + std::clamp(-relaxed, 0.0, amplitude_D);
  const double half_difference = std::hypot(0.5 * (excess(0, 0) - excess(1, 1)), 0.5 * (excess(0, 1) + excess(1, 0)));
  return DefocusAsWorn{mean, std::abs(mean) + half_difference};
}

}  // namespace sturm
