#pragma once
#include <optional>
#include <vector>

#include "pathtrace/cameras/general_camera.h"
#include "pathtrace/guide/pupil_slopes.h"

namespace sturm {

/// To first order, where the rays of one place of the picture pass a plane at the distance d along its chief ray:
/// x = c₀ + dc₁ + (P₀ + dP₁) p + (Q₀ + dQ₁) s for pupil point p and slope s. From differences of refracted rays; then c
/// and P are corrected to the least-squares map over the pupil, and the residual is what aberrations of the spectacles
/// are left.
struct ViewConoid {
  GeneralCamera::Bundle bundle;
  Eigen::Vector2d offset = Eigen::Vector2d::Zero(), direction = Eigen::Vector2d::Zero();  ///< c₀ [m], c₁
  double offset_residual_m = 0.0, direction_residual = 0.0;

  Eigen::Vector2d constant(double distance) const { return offset + distance * direction; }
  Eigen::Matrix2d by_point(double distance) const {
    return bundle.offset_by_point + distance * bundle.direction_by_point;
  }
  Eigen::Matrix2d by_slope(double distance) const {
    return bundle.offset_by_slope + distance * bundle.direction_by_slope;
  }
};

/// The conoids of a whole picture, known at corners 16 px or more apart and interpolated between them: they change
/// slowly over a lens. They decide where guided samples are sent and not what they are worth, so that an error in them
/// costs efficiency and nothing else.
class ViewConoidField {
 public:
  ViewConoidField(const GeneralCamera& camera, const PupilSlopes& slopes);

  /// At a film place [px]; none where the chief rays of all corners around it are lost.
  std::optional<ViewConoid> at(double film_x, double film_y) const;

  const std::vector<std::optional<ViewConoid>>& corners() const { return corners_; }

 private:
  int spacing_, across_, down_;
  std::vector<std::optional<ViewConoid>> corners_;
};

}  // namespace sturm
