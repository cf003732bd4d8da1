#include "conoid/tracing/spectacle_conoid.h"

#include <Eigen/LU>
#include <cmath>

#include "lensmodel/best_accommodation.h"
#include "lensmodel/gaze.h"
#include "lensmodel/units.h"

namespace sturm {

std::optional<Eigen::Matrix2d> SpectacleConoid::exit_curvature(const Eigen::Matrix2d& slopes) const {
  const Eigen::Matrix2d a = exit.offsets(slopes);
  if (!(std::abs(a.determinant()) > relative_singularity * a.squaredNorm())) return std::nullopt;
  const Eigen::Matrix2d k = -exit.slopes(slopes) * a.inverse();
  return Eigen::Matrix2d(0.5 * (k + k.transpose()));  // symmetric but for rounding
}

SpectacleConoid trace_conoid(const Spectacles& lens, const Eigen::Vector3d& gaze, double rotation_center_m) {
  const Eigen::Matrix3d turn = smallest_rotation({0.0, 0.0, -1.0}, gaze);
  return trace_conoid_along(lens, {turned_pupil_center(gaze, rotation_center_m), gaze}, turn * Eigen::Vector3d::UnitX(),
                            turn * Eigen::Vector3d::UnitY());
}

SpectacleConoid trace_conoid_along(const Spectacles& lens, const LightRay& line_of_sight, const Eigen::Vector3d& e1,
                                   const Eigen::Vector3d& e2) {
  const Eigen::Vector3d& gaze = line_of_sight.direction;
  SpectacleConoid conoid;
  const LensPath path = trace(lens, line_of_sight);
  conoid.status = path.status;
  if (path.status != LensStatus::ok) return conoid;
  conoid.chief_ray = path.exit;

  RayTransfer rays = transferred(RayTransfer::start(gaze, e1, e2), (path.back_point - line_of_sight.origin).norm());
  const auto back = Interface::refracting(gaze, path.back.normal, 1.0, lens.refractive_index);
  rays = transferred(through(rays, back.value(), path.back), (path.exit.origin - path.back_point).norm());
  const auto front = Interface::refracting(rays.direction, path.front.normal, lens.refractive_index, 1.0);
  if (!front) {  // within rounding of the critical angle, where the chief ray just passed
    conoid.status = LensStatus::total_internal_reflection;
    return conoid;
  }
  const Eigen::Matrix3d out = smallest_rotation({0.0, 0.0, -1.0}, path.exit.direction);
  conoid.exit = on_frame(through(rays, *front, path.front), out.col(0), out.col(1));
  return conoid;
}

double best_accommodation(const SpectacleConoid& conoid, const PowerMatrix& correction, double vergence_D,
                          double amplitude_D) {
  return best_accommodation(conoid.angular_footprint(correction.matrix(), vergence_D), conoid.angular_q(vergence_D),
                            amplitude_D);
}

double accommodation_through(const SpectacleConoid& conoid, const Eye& eye, double vergence_D) {
  if (const auto* best = std::get_if<BestAccommodation>(&eye.accommodation))
    return best_accommodation(conoid, eye.correction, vergence_D, best->amplitude_D);
  return eye.accommodation_for(vergence_D);
}

Footprint spectacle_footprint(const SpectacleConoid& conoid, const Eye& eye, double distance_m,
                              double accommodation_D) {
  const Eigen::Matrix2d slopes = eye.slope_matrix(accommodation_D).matrix();
  Footprint f;
  f.accommodation_D = accommodation_D;
  f.distance_m = distance_m;
  f.angular = conoid.angular_footprint(slopes, vergence_of(distance_m));
  f.wavefront_curvature = conoid.exit_curvature(slopes);
  return f;
}

}  // namespace sturm
