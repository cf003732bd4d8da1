#include "lensmodel/sag.h"

#include <cmath>

namespace sturm {

Eigen::Vector3d outward_normal(const Sag& sag) {
  return Eigen::Vector3d(sag.gradient.x(), sag.gradient.y(), -1.0) / std::sqrt(1.0 + sag.gradient.squaredNorm());
}

SurfaceElement::SurfaceElement(const Sag& sag) : normal(outward_normal(sag)), curvature(Eigen::Matrix3d::Zero()) {
  curvature.topLeftCorner<2, 2>() = -sag.hessian / std::sqrt(1.0 + sag.gradient.squaredNorm());
}

SurfaceElement SurfaceElement::turned(const Eigen::Matrix3d& rotation) const {
  SurfaceElement result;
  result.normal = rotation * normal;
  result.curvature = rotation * curvature * rotation.transpose();
  return result;
}

Eigen::Matrix2d tangent_curvature(const SurfaceElement& element, const Eigen::Vector3d& u, const Eigen::Vector3d& w) {
  Eigen::Matrix<double, 3, 2> across;
  across << u, w;
  return across.transpose() * element.curvature * across;
}

}  // namespace sturm
