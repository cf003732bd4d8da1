#pragma once
#include <Eigen/Core>
#include <optional>

#include "lensmodel/sag.h"

namespace sturm {

/// What a progressive surface is made from. Heights and positions are those of the lens about its fitting cross, where
/// it is worn before the pupil of primary gaze; down is towards the near zone.
struct ProgressiveSurfaceDesign {
  double far_power_D = 6.0;       ///< surface power of the far zone, (n − 1)/R
  double addition_D = 2.0;        ///< how much more the near zone has; may be negative
  double refractive_index = 1.5;  ///< > 1
  double corridor_start_m =
      0.0;  ///< height above the fitting cross at which the power begins to change; negative is below it
  double corridor_length_m = 14e-3;  ///< from there down to where it has changed by the addition; > 0
  double near_shift_m =
      0.0;  ///< x of the umbilic at the corridor's lower end, wearer frame: < 0 is the nose's side of a right eye
  std::optional<double>
      zone_width_m;  ///< how far from the umbilic the addition fades, > 0; none: circular sections, it never does
};

/// A progressive surface in closed form. Its umbilic lies in a plane and has the power P = far + addition·S₉(σ/length),
/// S₉ the smooth step of ninth degree (four continuous derivatives), σ counted along the umbilic's projection. Surface
/// frame with the vertex at the fitting cross, s downwards along the umbilic's projection, u across it, k = P/(n − 1),
/// sin ϑ = ∫₀ˢ k:
///
///     z = ∫₀ˢ tan ϑ + q(k_far) + (q(k) − q(k_far))·w²/(w² + u²),   q(k) = c u²/(1 + √(1 − c² u²)),   c = k/cos ϑ
///
/// Without a zone width w the sections across the umbilic are circles q(k), whose normal curvature there is that of the
/// umbilic: the first progressive lenses (Maitenaz, US 2869422 and 2915856). With it, what the addition does to the
/// sections fades at |u| ~ w. The change is of fourth order in u, so that the umbilic and its neighbourhood stay as
/// they are. Above the corridor the surface is a sphere. Off the umbilic Minkwitz's theorem holds: cylinder grows
/// across it twice as fast as power along it. The near zone is shifted by turning the design about the fitting cross
/// (as lenses with a symmetric design are fitted): a height that is sheared instead would no longer be umbilic; its
/// cylinder is 2P times the slope of the shift.
class ProgressiveSurface {
 public:
  /// Throws std::invalid_argument for what the design excludes.
  explicit ProgressiveSurface(const ProgressiveSurfaceDesign& design);

  /// z(x, y), exact to rounding; none where the surface does not reach.
  std::optional<Sag> sag(double x, double y) const;

  /// Power of the umbilic `s` [m] below the fitting cross along its projection.
  double umbilic_power_D(double s) const;

  /// Where the umbilic is `s` below the fitting cross, wearer axes [m].
  Eigen::Vector2d umbilic_at(double s) const { return s * down_; }

  const ProgressiveSurfaceDesign& design() const { return design_; }

 private:
  struct Bend {
    double k, first, second;  // curvature of the umbilic and its derivatives by s
    double sine;              // of ϑ: the integral of k from the fitting cross
  };
  Bend bend_at(double s) const;
  double turn_from_start(double s) const;
  std::optional<double> height_of_umbilic(double s) const;
  double height_in_corridor(double s) const;

  ProgressiveSurfaceDesign design_;
  Eigen::Vector2d down_, across_;
  double start_, end_;  // of the corridor, s
  double far_curvature_, added_curvature_;
  double turn_at_vertex_ = 0.0;
  std::optional<double> height_at_start_, height_at_end_;
};

}  // namespace sturm
