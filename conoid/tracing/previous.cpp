#include "conoid/tracing/previous.h"

#include <cmath>

#include "conoid/tracing/wavefront.h"
#include "lensmodel/gaze.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

/// A wave that comes in through a surface of the lens: normal and curvature are turned round.
std::optional<Wavefront> inward(const Wavefront& wave, const SurfaceElement& surface, double index_before,
                                double index_behind) {
  const auto at = Interface::refracting(wave.direction, -surface.normal, index_before, index_behind);
  if (!at) return std::nullopt;
  return through(wave, *at, -tangent_curvature(surface, at->u, at->tangent));
}

double ratio(double outside, double inside) {
  return std::abs(inside) < 1e-12 ? 1.0 : outside / inside;
}

const Eigen::Vector3d ahead(0.0, 0.0, -1.0);

}  // namespace

PreviousMethod::PreviousMethod(const Spectacles* lens, const Eigen::Vector3d& gaze, double rotation_center_m)
    : naked_(!lens), inside_(smallest_rotation(ahead, gaze)), outside_(inside_) {
  if (!lens) return;
  const Eigen::Vector3d pupil = turned_pupil_center(gaze, rotation_center_m);
  path_ = trace(*lens, {pupil, gaze});
  status_ = path_.status;
  if (status_ != LensStatus::ok) return;
  index_ = lens->refractive_index;
  to_back_ = (path_.back_point - pupil).norm();
  to_front_ = (path_.exit.origin - path_.back_point).norm();
  outside_ = smallest_rotation(ahead, path_.exit.direction);
  const auto angles = [](const Eigen::Vector3d& d) {
    return Eigen::Vector2d(std::atan2(d.x(), -d.z()), std::asin(d.y()));
  };
  const Eigen::Vector2d out = angles(path_.exit.direction), in = angles(gaze);
  widening_ = {ratio(out.x(), in.x()), ratio(out.y(), in.y())};
}

std::optional<Eigen::Matrix2d> PreviousMethod::vergence_at_pupil(double target_vergence_D) const {
  const Eigen::Matrix2d spherical = -target_vergence_D * Eigen::Matrix2d::Identity();
  if (naked_) return spherical;
  auto wave = inward({-path_.exit.direction, outside_.col(0), outside_.col(1), spherical}, path_.front, 1.0, index_);
  if (wave) wave = transferred(*wave, to_front_);
  if (wave) wave = inward(*wave, path_.back, index_, 1.0);
  if (wave) wave = transferred(*wave, to_back_);
  if (!wave) return std::nullopt;
  return wave->on(inside_.col(0), inside_.col(1)).curvature;
}

std::optional<PreviousBlur> PreviousMethod::blur(const Eigen::Matrix2d& needed, double target_vergence_D) const {
  const auto vergence = vergence_at_pupil(target_vergence_D);
  if (!vergence) return std::nullopt;
  return PreviousBlur{needed - *vergence, widening_, 1.0 + target_vergence_D * inside_length()};
}

std::optional<PreviousBlur> previous_blur(const Eye& eye, double accommodation_D, const Spectacles* lens,
                                          const Eigen::Vector3d& gaze, double distance_m) {
  const PreviousMethod method(lens, gaze, eye.rotation_center_m);
  if (method.status() != LensStatus::ok) return std::nullopt;
  return method.blur(eye.slope_matrix(accommodation_D).matrix(), vergence_of(distance_m));
}

std::optional<Eigen::Matrix2d> previous_angular_footprint(const Eye& eye, double accommodation_D,
                                                          const Spectacles* lens, const Eigen::Vector3d& gaze,
                                                          double distance_m) {
  const auto blur = previous_blur(eye, accommodation_D, lens, gaze, distance_m);
  return blur ? std::optional(blur->angular()) : std::nullopt;
}

}  // namespace sturm
