#pragma once
#include "lensmodel/mounting.h"
#include "lensmodel/surface.h"

namespace sturm {

/// A thick spectacle lens in front of one eye. Wearer frame, origin at the pupil's centre in primary gaze. Lens frame:
/// origin at the back vertex, z along the lens's axis towards the eye; parallel to the wearer frame unless the mounting
/// turns it.
struct Spectacles {
  Surface back, front;               ///< towards the eye, and towards the scene; each in its own surface frame
  double center_thickness_m = 2e-3;  ///< > 0
  double refractive_index = 1.5;     ///< ≥ 1
  double vertex_distance_m = 12e-3;  ///< of the back vertex from the plane of the pupil, ≥ 0
  double diameter_m = 70e-3;         ///< of the rim, for both surfaces, each about its own axis
  Mounting mounting{};               ///< how it stands before the eye; straight unless stated

  /// Back vertex in the wearer frame [m].
  Eigen::Vector3d back_vertex() const {
    return {mounting.decentration_m().x(), mounting.decentration_m().y(), -vertex_distance_m};
  }
};

/// The way of one ray from the eye through the lens into the air before it, by Snell's law at both surfaces. Wearer
/// frame [m].
struct LensPath {
  LensStatus status = LensStatus::missed_lens;   ///< whether the ray came through, or what stopped it
  Eigen::Vector3d back_point, inside_direction;  ///< where it enters the glass, and its unit direction there
  LightRay exit;                                 ///< starts on the front surface
  SurfaceElement back, front;                    ///< the surfaces where the ray meets them
};

/// False where a ray that leaves the eye certainly passes outside of the rim of the back surface.
bool may_meet(const Spectacles& spectacles, const LightRay& ray);

/// Follows a ray that starts between eye and lens outwards. Points and directions behind the place where it was lost
/// mean nothing.
LensPath trace(const Spectacles& spectacles, const LightRay& ray);

}  // namespace sturm
