#pragma once
#include <Eigen/Core>
#include <optional>

#include "lensmodel/ellipse.h"
#include "lensmodel/eye.h"

namespace sturm {

/// First-order footprint of the pupil at one target (docs/theory.md#4-the-footprint-of-the-pupil and
/// docs/theory.md#113-conoid-tracing-as-ray-transfer): a point p of the pupil sends its ray through X p at the target's
/// distance. At infinity only the angular map exists.
struct Footprint {
  double accommodation_D = 0.0;  ///< A of the eye for this target [D]
  double distance_m = 0.0;       ///< may be ∞
  Eigen::Matrix2d angular;       ///< X/d [rad/m]; I/d + F − A·I for the naked eye
  /// Of the wave that leaves the pupil, or the spectacles, at the chief ray [D], positive = converging towards the
  /// scene: −(F − A·I) for the naked eye. None at a focal line.
  std::optional<Eigen::Matrix2d> wavefront_curvature;

  /// X [m/m]; only for finite distances.
  Eigen::Matrix2d transverse() const { return distance_m * angular; }
};

/// Traces the naked eye's conoid to `distance_m` > 0 (∞ allowed).
Footprint naked_eye_footprint(const Eye& eye, double distance_m);

/// The same for a given accommodation A [D].
Footprint naked_eye_footprint(const Eye& eye, double distance_m, double accommodation_D);

}  // namespace sturm
