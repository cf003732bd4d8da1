#include "lensmodel/sag.h"

#include <cmath>

namespace sturm {

Eigen::Vector3d outward_normal(const Sag& sag) {
  return Eigen::Vector3d(sag.gradient.x(), sag.gradient.y(), -1.0) / std::sqrt(1.0 + sag.gradient.squaredNorm());
}

Eigen::Matrix2d tangent_curvature(const Sag& sag, const Eigen::Vector3d& u, const Eigen::Vector3d& w) {
  Eigen::Matrix2d across;
  across << u.x(), w.x(), u.y(), w.y();
  return -across.transpose() * sag.hessian * across / std::sqrt(1.0 + sag.gradient.squaredNorm());
}

}  // namespace sturm
