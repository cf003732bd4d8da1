#pragma once
#include <Eigen/Geometry>

#include "io/specs/scene_spec.h"

namespace sturm {

/// Where the points of a model file come to stand: scaled, turned about +y, then moved. In double: a model may lie far
/// from its origin and be put back, and single precision is left with what remains.
class ModelPlacement {
 public:
  explicit ModelPlacement(const ModelSpec& spec)
      : turn_(Eigen::AngleAxisd(spec.turn, Eigen::Vector3d::UnitY()).toRotationMatrix()),
        scale_(spec.scale),
        position_(spec.position) {}

  /// [m], world; from units of the file.
  Eigen::Vector3d point(const Eigen::Vector3d& in_file) const { return turn_ * (scale_ * in_file) + position_; }
  /// The same as a transformation.
  Eigen::Affine3d scene_from_file() const {
    return Eigen::Translation3d(position_) * Eigen::Affine3d(Eigen::Matrix3d(scale_ * turn_));
  }
  const Eigen::Matrix3d& turn() const { return turn_; }
  double scale() const { return scale_; }

 private:
  Eigen::Matrix3d turn_;
  double scale_;
  Eigen::Vector3d position_;
};

}  // namespace sturm
