#include "conoid/tracing/interface.h"

#include <Eigen/Geometry>
#include <cmath>

namespace sturm {

namespace {

/// Below this |N × n| the plane of incidence means nothing and any u ⊥ N will do.
constexpr double normal_incidence = 1e-9;

/// N × n as a unit vector across N. The product of nearly parallel vectors is rounded to 1e-16 of *their* length, so at
/// an incidence of 1e-8 it leans out of the tangent plane by 1e-8, and curvatures on it would be wrong by as much: what
/// lies along N is taken away again.
Eigen::Vector3d across_direction(const Eigen::Vector3d& direction, const Eigen::Vector3d& across) {
  const Eigen::Vector3d u = across.normalized();
  return (u - u.dot(direction) / direction.squaredNorm() * direction).normalized();
}

Interface with_frames(const Eigen::Vector3d& direction, const Eigen::Vector3d& normal, double mu, double cos_out) {
  Interface i;
  i.mu = mu;
  i.cos_in = direction.dot(normal);
  i.cos_out = cos_out;
  i.gamma = cos_out - mu * i.cos_in;
  i.direction_out = (mu * direction + i.gamma * normal).normalized();
  const Eigen::Vector3d across = direction.cross(normal);
  i.u = across.norm() < normal_incidence ? Eigen::Vector3d(direction.unitOrthogonal())
                                         : across_direction(direction, across);
  i.v = direction.cross(i.u);
  i.v_out = i.direction_out.cross(i.u);
  i.tangent = normal.cross(i.u);
  return i;
}

}  // namespace

std::optional<Interface> Interface::refracting(const Eigen::Vector3d& direction, const Eigen::Vector3d& normal,
                                               double index_before, double index_behind) {
  const double mu = index_before / index_behind, cos_in = direction.dot(normal);
  const double square = 1.0 - mu * mu * (1.0 - cos_in * cos_in);
  if (!(square > 0.0)) return std::nullopt;
  return with_frames(direction, normal, mu, std::sqrt(square));
}

Interface Interface::reflecting(const Eigen::Vector3d& direction, const Eigen::Vector3d& normal) {
  return with_frames(direction, normal, 1.0, -direction.dot(normal));
}

Eigen::Matrix2d change_of_frame(const Eigen::Vector3d& from1, const Eigen::Vector3d& from2, const Eigen::Vector3d& to1,
                                const Eigen::Vector3d& to2) {
  Eigen::Matrix2d change;
  change << to1.dot(from1), to1.dot(from2), to2.dot(from1), to2.dot(from2);
  return change;
}

}  // namespace sturm
