#pragma once
#include <Eigen/Core>
#include <optional>

#include "lensmodel/accommodation.h"
#include "lensmodel/power_matrix.h"
#include "lensmodel/zernike_wave.h"

namespace sturm {

/// Of a mean eye, behind its pupil [m].
inline constexpr double mean_rotation_center_m = 13.5e-3;

/// Thin-lens eye (docs/theory.md#3-the-eye). Pupil, cornea and principal plane coincide. Both predictors read this one
/// object.
struct Eye {
  Prescription
      prescription;  ///< as written; `correction` is the same at the cornea. Of a wavefront: its second-order power
  PowerMatrix correction;  ///< F, the correcting power at the cornea [D], wearer frame; a myope's is negative
  std::optional<ZernikeWave>
      wavefront;  ///< if one was measured: all of it, `correction` included; its pupil is not smaller than the eye's
  double pupil_radius_m = 2e-3;                          ///< a ≥ 0; 0 is a pinhole
  double rotation_center_m = mean_rotation_center_m;     ///< distance of the centre of rotation behind the pupil
  Accommodation accommodation = RelaxedAccommodation{};  ///< what the eye does for each target
  double stiles_crawford_per_m2 =
      0.0;  ///< ρ ≥ 0 of the weight 10^(−ρ r²) of light through the pupil at r [1/m²]; 0: all alike

  /// Checks ranges and applies the vertex distance. Throws std::invalid_argument or std::domain_error.
  static Eye with(const Prescription& rx, double pupil_diameter_m,
                  const Accommodation& accommodation = RelaxedAccommodation{});

  /// The same for a measured wavefront, and the prescription that adds to it if there is one. Throws
  /// std::invalid_argument where the pupil is larger than the wavefront's.
  static Eye with(const ZernikeWave& measured, SecondOrder rule, const std::optional<Prescription>& rx,
                  double pupil_diameter_m, const Accommodation& accommodation = RelaxedAccommodation{});

  /// S = F − A·I: maps a pupil offset [m] to the slope of the ray that leaves the eye there, for an accommodation A
  /// [D].
  PowerMatrix slope_matrix(double accommodation_D) const { return correction - PowerMatrix::scalar(accommodation_D); }

  /// The accommodation A [D] for a target at vergence 1/d [D] (0 at infinity), naked eye. `best` is clamp(1/d + M, 0,
  /// A_max).
  double accommodation_for(double target_vergence_D) const;

  /// The distance that the accommodation was stated as [m], where it was; the metalstigmatism model needs it.
  std::optional<double> stated_focus_distance_m() const;
};

}  // namespace sturm
