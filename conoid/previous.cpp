#include "conoid/previous.h"

#include <cmath>

#include "conoid/wavefront.h"
#include "lensmodel/gaze.h"

namespace sturm {

namespace {

/// A wave that comes in through a surface of the lens: normal and curvature are turned round.
std::optional<Wavefront> inward(const Wavefront& wave, const SurfaceElement& surface, double index_before, double index_behind) {
  const auto at = Interface::refracting(wave.direction, -surface.normal, index_before, index_behind);
  if (!at) return std::nullopt;
  return through(wave, *at, -tangent_curvature(surface, at->u, at->tangent));
}

double ratio(double outside, double inside) {
  return std::abs(inside) < 1e-12 ? 1.0 : outside / inside;
}

}  // namespace

std::optional<PreviousBlur> previous_blur(const Eye& eye, double accommodation_D, const Spectacles* lens, const Eigen::Vector3d& gaze,
                                          double distance_m) {
  const double vergence = std::isinf(distance_m) ? 0.0 : 1.0 / distance_m;
  const Eigen::Matrix2d needed = eye.slope_matrix(accommodation_D).matrix(), spherical = -vergence * Eigen::Matrix2d::Identity();
  if (!lens) return PreviousBlur{needed - spherical, {1.0, 1.0}, 1.0};

  const Eigen::Vector3d pupil = turned_pupil_center(gaze, eye.rotation_center_m);
  const LensPath path = trace(*lens, {pupil, gaze});
  if (path.status != LensStatus::ok) return std::nullopt;
  const double to_back = (path.back_point - pupil).norm(), to_front = (path.exit.origin - path.back_point).norm();

  const Eigen::Matrix3d outside = smallest_rotation({0.0, 0.0, -1.0}, path.exit.direction),
                        turn = smallest_rotation({0.0, 0.0, -1.0}, gaze);
  auto wave = inward({-path.exit.direction, outside.col(0), outside.col(1), spherical}, path.front, 1.0, lens->refractive_index);
  if (wave) wave = transferred(*wave, to_front);
  if (wave) wave = inward(*wave, path.back, lens->refractive_index, 1.0);
  if (wave) wave = transferred(*wave, to_back);
  if (!wave) return std::nullopt;  // a focus exactly at a surface or the pupil, where V is infinite

  const auto angles = [](const Eigen::Vector3d& d) { return Eigen::Vector2d(std::atan2(d.x(), -d.z()), std::asin(d.y())); };
  const Eigen::Vector2d out = angles(path.exit.direction), in = angles(gaze);
  const Eigen::Vector2d widening(ratio(out.x(), in.x()), ratio(out.y(), in.y()));
  const double length = 1.0 + vergence * (to_back + to_front);  // path from pupil to object over the distance from the exit point
  return PreviousBlur{needed - wave->on(turn.col(0), turn.col(1)).curvature, widening, length};
}

std::optional<Eigen::Matrix2d> previous_angular_footprint(const Eye& eye, double accommodation_D, const Spectacles* lens,
                                                          const Eigen::Vector3d& gaze, double distance_m) {
  const auto blur = previous_blur(eye, accommodation_D, lens, gaze, distance_m);
  return blur ? std::optional(blur->angular()) : std::nullopt;
}

}  // namespace sturm
