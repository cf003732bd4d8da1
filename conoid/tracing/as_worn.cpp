#include "conoid/tracing/as_worn.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "conoid/tracing/spectacle_conoid.h"
#include "lensmodel/gaze.h"
#include "lensmodel/symmetric2.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

/// Slopes S of the rays that stand on the vertex sphere at p and leave the lens parallel to the chief ray. With the
/// pupil's offset p − v S p: C (p − v S p) + D S p = 0, so S = −(D − v C)⁻¹ C. The light that comes back on them
/// converges where they diverge.
std::optional<PowerMatrix> vergence_at_vertex_sphere(const RayTransfer& rays, double vertex_distance_m) {
  const Eigen::Matrix2d c = rays.slope_from_offset, d = rays.slope_from_slope - vertex_distance_m * c;
  // Against the size of what was subtracted: at a point focus all of D − v C is rounding.
  const double size = rays.slope_from_slope.norm() + vertex_distance_m * c.norm();
  if (!(singular_values(d).small > SpectacleConoid::relative_singularity * size)) return std::nullopt;
  const Eigen::Matrix2d s = -d.inverse() * c;
  return PowerMatrix::from_components(s(0, 0), 0.5 * (s(0, 1) + s(1, 0)), s(1, 1));  // symmetric but for rounding
}

}  // namespace

double AsWorn::prism_cm_per_m() const {
  return 100.0 * std::tan(deviation_rad);
}

AsWorn as_worn(const Spectacles& lens, const Eigen::Vector3d& gaze, double rotation_center_m) {
  const SpectacleConoid conoid = trace_conoid(lens, gaze, rotation_center_m);
  AsWorn worn;
  worn.status = conoid.status;
  if (worn.status != LensStatus::ok) return worn;
  const Eigen::Vector3d out = conoid.chief_ray.direction;
  worn.deviation_rad = std::atan2(gaze.cross(out).norm(), gaze.dot(out));
  // Light bends towards the base whichever way it runs. The examiner's x is the wearer's −x.
  const Eigen::Matrix3d turn = smallest_rotation({0.0, 0.0, -1.0}, gaze);
  const double right = -turn.col(0).dot(out), up = turn.col(1).dot(out);
  if (right != 0.0 || up != 0.0) {
    const double angle = std::atan2(up, right) / radians_per_degree;
    worn.base_deg = angle < 0.0 ? std::fmod(angle + 360.0, 360.0) : angle + 0.0;
  }
  worn.power = vergence_at_vertex_sphere(conoid.exit, lens.vertex_distance_m);
  return worn;
}

}  // namespace sturm
