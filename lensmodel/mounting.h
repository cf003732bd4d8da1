#pragma once
#include <Eigen/Core>

namespace sturm {

/// How a lens stands before the eye, and how its two surfaces stand to each other. Immutable; the rotations are made
/// once.
class Mounting {
 public:
  /// Straight: the lens's axis is the line of sight of primary gaze.
  Mounting() = default;

  /// `decentration_m`: of the back vertex from the line of sight of primary gaze, wearer frame. `pantoscopic_tilt`
  /// [rad] is positive where the lower rim stands nearer to the wearer; `wrap` [rad] is positive where the rim on the
  /// wearer's right does (face form of a right lens). The lens turns about its back vertex: first the tilt, then the
  /// wrap about the vertical.
  Mounting(const Eigen::Vector2d& decentration_m, double pantoscopic_tilt, double wrap);

  /// The same with the back surface turned about its vertex against the lens's axis, so that its tangent plane there
  /// has the slopes `slopes` (∂z/∂x, ∂z/∂y) in the lens's frame: a prism.
  Mounting with_wedge(const Eigen::Vector2d& slopes) const;

  bool straight() const { return straight_; }                                ///< neither tilted, wrapped nor decentred
  bool has_wedge() const { return has_wedge_; }                              ///< the surfaces' axes differ
  const Eigen::Vector2d& decentration_m() const { return decentration_m_; }  ///< of the back vertex, wearer frame
  double pantoscopic_tilt() const { return pantoscopic_tilt_; }              ///< [rad], as in the constructor
  double wrap() const { return wrap_; }                                      ///< [rad], as in the constructor
  const Eigen::Vector2d& wedge() const { return wedge_; }  ///< slopes as in with_wedge; 0 without a prism

  const Eigen::Matrix3d& wearer_from_lens() const { return wearer_from_lens_; }  ///< rotation
  const Eigen::Matrix3d& lens_from_back() const { return lens_from_back_; }      ///< rotation about the back vertex

 private:
  Eigen::Vector2d decentration_m_ = Eigen::Vector2d::Zero(), wedge_ = Eigen::Vector2d::Zero();
  double pantoscopic_tilt_ = 0.0, wrap_ = 0.0;
  bool straight_ = true, has_wedge_ = false;
  Eigen::Matrix3d wearer_from_lens_ = Eigen::Matrix3d::Identity(), lens_from_back_ = Eigen::Matrix3d::Identity();
};

}  // namespace sturm
