#include "bench/hoisted_previous.h"

#include <Eigen/LU>
#include <cmath>

#include "conoid/tracing/interface.h"
#include "lensmodel/gaze.h"

namespace sturm::bench {

namespace {

/// √μ C C'⁻¹ on (u, v).
Eigen::Vector2d scale_of(const Interface& at) {
  return {std::sqrt(at.mu), std::sqrt(at.mu) * at.cos_in / at.cos_out};
}

Eigen::Matrix2d bend_of(const Interface& at, const SurfaceElement& surface) {
  const Eigen::Vector2d out_inverse(1.0, 1.0 / at.cos_out);
  const Eigen::Matrix2d curvature = -tangent_curvature(surface, at.u, at.tangent);  // met from outside
  return at.gamma * (out_inverse.asDiagonal() * curvature * out_inverse.asDiagonal());
}

Eigen::Matrix2d refracted(const Eigen::Matrix2d& k, const Eigen::Vector2d& scale, const Eigen::Matrix2d& bend) {
  return scale.asDiagonal() * k * scale.asDiagonal() + bend;
}

Eigen::Matrix2d transferred(const Eigen::Matrix2d& k, double distance) {
  return k * (Eigen::Matrix2d::Identity() - distance * k).inverse();
}

}  // namespace

HoistedPrevious::HoistedPrevious(const Spectacles& lens, const Eigen::Vector3d& gaze, double rotation_center_m) {
  const PreviousMethod method(&lens, gaze, rotation_center_m);
  if (method.status() != LensStatus::ok) return;
  const LensPath& path = method.path();
  const auto front = Interface::refracting(-path.exit.direction, -path.front.normal, 1.0, lens.refractive_index);
  if (!front) return;
  const auto back = Interface::refracting(front->direction_out, -path.back.normal, lens.refractive_index, 1.0);
  if (!back) return;
  usable_ = true;
  to_front_ = (path.exit.origin - path.back_point).norm();
  to_back_ = method.inside_length() - to_front_;
  inside_length_ = method.inside_length();
  front_scale_ = scale_of(*front);
  back_scale_ = scale_of(*back);
  front_bend_ = bend_of(*front, path.front);
  back_bend_ = bend_of(*back, path.back);
  const Eigen::Matrix3d turn = smallest_rotation({0.0, 0.0, -1.0}, gaze);
  back_from_front_ = change_of_frame(front->u, front->v_out, back->u, back->v);
  pupil_from_back_ = change_of_frame(back->u, back->v_out, turn.col(0), turn.col(1));
  widening_ = method.widening();
}

Eigen::Matrix2d HoistedPrevious::angular_footprint(const Eigen::Matrix2d& needed, double vergence) const {
  Eigen::Matrix2d k = front_bend_;
  k.diagonal() -= vergence * front_scale_.cwiseAbs2();  // the wave from the object is spherical
  k = transferred(k, to_front_);
  k = refracted(back_from_front_ * k * back_from_front_.transpose(), back_scale_, back_bend_);
  k = transferred(k, to_back_);
  const Eigen::Matrix2d missing = needed - pupil_from_back_ * k * pupil_from_back_.transpose();
  return (1.0 + vergence * inside_length_) * (widening_.asDiagonal() * missing);
}

}  // namespace sturm::bench
