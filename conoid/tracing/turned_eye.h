#pragma once
#include <Eigen/Core>
#include <optional>

#include "conoid/tracing/footprint.h"
#include "conoid/tracing/spectacle_conoid.h"
#include "lensmodel/eye.h"
#include "lensmodel/light_ray.h"
#include "lensmodel/spectacles.h"

namespace sturm {

/// An eye that has turned to one line of sight, naked or behind its spectacles, and the conoid of its chief ray: one
/// answer for all distances. Wearer frame.
class TurnedEye {
 public:
  /// `lens` null is the naked eye. `gaze` is a unit vector; Listing's law about the eye's centre of rotation.
  TurnedEye(const Eye& eye, const Spectacles* lens, const Eigen::Vector3d& gaze);

  LensStatus status() const { return conoid_ ? conoid_->status : LensStatus::ok; }  ///< of the chief ray

  /// From the pupil's centre, or from the exit point on the front surface; status must be ok.
  const LightRay& chief_ray() const { return conoid_ ? conoid_->chief_ray : line_of_sight_; }

  /// From the pupil's centre to what the eye looks at through its lens.
  const LightRay& line_of_sight() const { return line_of_sight_; }

  /// The accommodation [D] for a target at 1/`vergence_D` along the chief ray; status must be ok.
  double accommodation(double vergence_D) const;

  /// The footprint at `distance_m` > 0 along the chief ray (∞ allowed); status must be ok.
  Footprint footprint(double distance_m, double accommodation_D) const;

  /// With the accommodation for that distance.
  Footprint footprint(double distance_m) const;

 private:
  Eye eye_;
  LightRay line_of_sight_;
  std::optional<SpectacleConoid> conoid_;  // of spectacles
};

}  // namespace sturm
