#pragma once
#include "lensmodel/surface.h"

namespace sturm {

/// A thick spectacle lens in front of one eye. Wearer frame, origin at the pupil's centre in primary gaze; the lens's axis is the line
/// of sight of that gaze, and its back vertex stands `vertex_distance_m` in front of the pupil.
struct Spectacles {
  Surface back, front;
  double center_thickness_m = 2e-3;  ///< > 0
  double refractive_index = 1.5;     ///< ≥ 1
  double vertex_distance_m = 12e-3;  ///< ≥ 0
  double diameter_m = 70e-3;         ///< of the rim, for both surfaces

  double back_vertex_z() const { return -vertex_distance_m; }
  double front_vertex_z() const { return -vertex_distance_m - center_thickness_m; }
};

/// The way of one ray from the eye through the lens into the air before it, by Snell's law at both surfaces. Wearer frame [m].
struct LensPath {
  LensStatus status = LensStatus::missed_lens;
  Eigen::Vector3d back_point, inside_direction;
  LightRay exit;            ///< starts on the front surface
  Sag back_sag, front_sag;  ///< the surfaces where the ray meets them
};

/// Follows a ray that starts between eye and lens outwards. Points and directions behind the place where it was lost mean nothing.
LensPath trace(const Spectacles& spectacles, const LightRay& ray);

}  // namespace sturm
