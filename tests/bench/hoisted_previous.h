#pragma once
#include "conoid/tracing/previous.h"

namespace sturm::bench {

/// The previous method with all that one direction has in common taken out of the loop over the depths: Snell's law,
/// the frames and the surfaces' curvatures. It gives the numbers of PreviousMethod::blur; what is left per voxel are
/// two refractions and two transfers of 2×2 matrices.
class HoistedPrevious {
 public:
  HoistedPrevious(const Spectacles& lens, const Eigen::Vector3d& gaze, double rotation_center_m);

  bool usable() const { return usable_; }
  Eigen::Matrix2d angular_footprint(const Eigen::Matrix2d& needed, double target_vergence_D) const;

 private:
  bool usable_ = false;
  double to_front_ = 0.0, to_back_ = 0.0, inside_length_ = 0.0;
  Eigen::Vector2d front_scale_, back_scale_;  ///< μ C²/C'² and √μ C/C' on the axes (u, v)
  Eigen::Matrix2d front_bend_, back_bend_;    ///< γ C'⁻¹ K_s C'⁻¹
  Eigen::Matrix2d back_from_front_, pupil_from_back_;
  Eigen::Vector2d widening_;
};

}  // namespace sturm::bench
