#pragma once
#include <Eigen/Core>
#include <numbers>
#include <optional>

#include "lensmodel/chromatic_eye.h"
#include "lensmodel/eye.h"
#include "wavefront/psf/pupil_sector.h"

namespace sturm {

inline constexpr double two_pi = 2.0 * std::numbers::pi;  ///< 2π

/// The wave in an eye's pupil, from which its point spreads follow (docs/theory.md#142-point-spreads).
/// With a vergence error V added it is W(p) − ½ V |p|² over |p| ≤ radius. The image of a point stands at X = +∇W
/// [rad], an angle in object space from where the point is, in the frame of the pupil (x right, y up).
struct PupilWave {
  ZernikeWave wave;               ///< its own pupil may be larger
  double radius_m;                ///< > 0
  double stiles_crawford_per_m2;  ///< ρ: light through p counts 10^(−ρ |p|²), its amplitude the root of it
  double in_focus_nm;             ///< wavelength that the wave is stated for

  /// Of an eye's wavefront, or of its prescription. Throws std::invalid_argument for a pinhole.
  static PupilWave of(const Eye& eye, double in_focus_nm);

  /// The same seen from the other side, x → −x: from the wearer's frame to the examiner's.
  PupilWave mirrored() const;

  /// W [m] and its gradient [rad] at a pupil point [m] with the vergence error V [D].
  double height(const Eigen::Vector2d& p, double vergence_D) const {
    return wave.height(p) - 0.5 * vergence_D * p.squaredNorm();
  }
  Eigen::Vector2d gradient(const Eigen::Vector2d& p, double vergence_D) const {
    return -wave.slope(p) - vergence_D * p;
  }  ///< as height

  /// V at a wavelength: that of the target, and the eye's own chromatic difference.
  double vergence_at(double wavelength_nm, double vergence_D) const {
    return vergence_D + chromatic_vergence_D(wavelength_nm, in_focus_nm);
  }

  /// The share of its light that counts at |p|², 0 … 1.
  double intensity(double square_m2) const;

  /// ∫ intensity dp over the pupil [m²].
  double area_m2() const;

  /// The share of a part of the pupil in that.
  double share_of(const PupilSector& sector) const;

  /// A bound of |∂W/∂x| and |∂W/∂y| over the pupil [rad] in all of the light: the largest on a fine grid and 2 % more.
  double largest_slope(const Light& light, double vergence_D) const;
};

}  // namespace sturm
