#pragma once
#include <Eigen/Core>
#include <optional>

#include "lensmodel/eye.h"
#include "lensmodel/spectacles.h"

namespace sturm {

/// What the method before conoid tracing finds, and what it is scaled by.
struct PreviousBlur {
  Eigen::Matrix2d inside;  ///< F − A·I − V [rad/m]: the blur as an angle inside, on the axes of the turned pupil; first
                           ///< order, exact
  Eigen::Vector2d widening;  ///< chief ray's angle outside over inside: azimuth, elevation
  double length;             ///< path from pupil to object over the object's distance from the exit point

  /// The map of the pupil divided by the distance [rad/m], on the axes across the outgoing chief ray.
  Eigen::Matrix2d angular() const { return length * (widening.asDiagonal() * inside); }
};

/// The method before conoid tracing ([Kakimoto2010] Table 1) for one direction of gaze, traced from the object: a
/// spherical wave from the point at 1/d along the outgoing chief ray goes through front and back surface to the turned
/// eye. Its vergence V at the pupil against the needed F − A·I gives the blur as an angle inside, F − A·I − V [rad/m].
///
/// To the object it is scaled by the path length from pupil to object, and by the ratio of the chief ray's angles
/// outside and inside, azimuth for the horizontal and elevation for the vertical (1 where an angle vanishes). The paper
/// gives no formula for this scaling; this reading is ours.
class PreviousMethod {
 public:
  /// The eye looks along `gaze` through `lens`; null is the naked eye, for which the method is exact.
  PreviousMethod(const Spectacles* lens, const Eigen::Vector3d& gaze, double rotation_center_m);

  LensStatus status() const { return status_; }                  ///< of the chief ray; unless ok the rest means nothing
  const LensPath& path() const { return path_; }                 ///< of the chief ray; with a lens only
  const Eigen::Vector2d& widening() const { return widening_; }  ///< ratio of the angles, horizontally and vertically
  double inside_length() const { return to_back_ + to_front_; }  ///< from the pupil to the exit point [m]

  /// V [D] on the axes of the turned pupil, every step of the way anew. None at a focus exactly on a surface or on the
  /// pupil.
  std::optional<Eigen::Matrix2d> vergence_at_pupil(double target_vergence_D) const;

  /// `needed` is F − A·I. None likewise.
  std::optional<PreviousBlur> blur(const Eigen::Matrix2d& needed, double target_vergence_D) const;

 private:
  LensStatus status_ = LensStatus::ok;
  bool naked_;
  double index_ = 1.0, to_back_ = 0.0, to_front_ = 0.0;
  LensPath path_;
  Eigen::Matrix3d inside_, outside_;  ///< axes of the turned pupil, and across the outgoing chief ray
  Eigen::Vector2d widening_{1.0, 1.0};
};

/// One target at `distance_m` > 0 (∞ allowed). None where the chief ray is lost or a focus makes V infinite.
std::optional<PreviousBlur> previous_blur(const Eye& eye, double accommodation_D, const Spectacles* spectacles,
                                          const Eigen::Vector3d& gaze, double distance_m);

/// Its map alone.
std::optional<Eigen::Matrix2d> previous_angular_footprint(const Eye& eye, double accommodation_D,
                                                          const Spectacles* spectacles, const Eigen::Vector3d& gaze,
                                                          double distance_m);

}  // namespace sturm
