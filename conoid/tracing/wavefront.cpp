#include "conoid/tracing/wavefront.h"

#include <Eigen/LU>

namespace sturm {

Wavefront Wavefront::on(const Eigen::Vector3d& f1, const Eigen::Vector3d& f2) const {
  const Eigen::Matrix2d change = change_of_frame(e1, e2, f1, f2);
  return {direction, f1, f2, change * curvature * change.transpose()};
}

std::optional<Wavefront> transferred(const Wavefront& wave, double distance) {
  const Eigen::Matrix2d stretch = Eigen::Matrix2d::Identity() - distance * wave.curvature;
  if (stretch.determinant() == 0.0) return std::nullopt;
  Wavefront moved = wave;
  moved.curvature = wave.curvature * stretch.inverse();
  return moved;
}

Wavefront through(const Wavefront& wave, const Interface& at, const Eigen::Matrix2d& surface_curvature) {
  const Eigen::Vector2d in(1.0, at.cos_in), out(1.0, 1.0 / at.cos_out);  // diagonals of C and C'⁻¹
  const Eigen::Matrix2d k = wave.on(at.u, at.v).curvature;
  const Eigen::Matrix2d on_surface = at.mu * (in.asDiagonal() * k * in.asDiagonal()) + at.gamma * surface_curvature;
  return {at.direction_out, at.u, at.v_out, out.asDiagonal() * on_surface * out.asDiagonal()};
}

Wavefront through(const Wavefront& wave, const Interface& at, const SurfaceElement& surface) {
  return through(wave, at, tangent_curvature(surface, at.u, at.tangent));
}

Wavefront through_thin_lens(const Wavefront& wave, const Eigen::Matrix2d& power, double index_before,
                            double index_behind) {
  Wavefront behind = wave;
  behind.curvature = (index_before * wave.curvature + power) / index_behind;
  return behind;
}

}  // namespace sturm
