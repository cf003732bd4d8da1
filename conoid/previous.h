#pragma once
#include <Eigen/Core>
#include <optional>

#include "lensmodel/eye.h"
#include "lensmodel/spectacles.h"

namespace sturm {

/// What the method before conoid tracing finds, and what it is scaled by.
struct PreviousBlur {
  Eigen::Matrix2d inside;    ///< F − A·I − V [rad/m]: the blur as an angle inside, on the axes of the turned pupil; first order, exact
  Eigen::Vector2d widening;  ///< chief ray's angle outside over inside: azimuth, elevation
  double length;             ///< path from pupil to object over the object's distance from the exit point

  /// The map of the pupil divided by the distance [rad/m], on the axes across the outgoing chief ray.
  Eigen::Matrix2d angular() const { return length * (widening.asDiagonal() * inside); }
};

/// The method before conoid tracing ([Kakimoto2010] Table 1), traced from the object: a spherical wave from the point at `distance_m`
/// (∞ allowed) along the outgoing chief ray goes through front and back surface to the turned eye. Its vergence V at the pupil against the
/// needed F − A·I gives the blur as an angle inside, F − A·I − V [rad/m].
///
/// To the object it is scaled by the path length from pupil to object, and by the ratio of the chief ray's angles outside and inside,
/// azimuth for the horizontal and elevation for the vertical (1 where an angle vanishes). The paper gives no formula for this scaling; this
/// reading is ours. None where the chief ray is lost, or a focus of the wave lies in a surface or the pupil. `spectacles` null: the naked
/// eye, exact.
std::optional<PreviousBlur> previous_blur(const Eye& eye, double accommodation_D, const Spectacles* spectacles, const Eigen::Vector3d& gaze,
                                          double distance_m);

/// Its map alone.
std::optional<Eigen::Matrix2d> previous_angular_footprint(const Eye& eye, double accommodation_D, const Spectacles* spectacles,
                                                          const Eigen::Vector3d& gaze, double distance_m);

}  // namespace sturm
