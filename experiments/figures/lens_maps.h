#pragma once
#include <vector>

#include "io/specs/spectacles_spec.h"
#include "lensmodel/power_matrix.h"
#include "lensmodel/spectacles.h"
#include "reports/plots/lens_map.h"

namespace sturm {

inline constexpr int lens_map_samples = 161;  ///< each way, over the rim's diameter

/// The power that a lens was made for, or has on its axis. Throws InputError about `where` for a lens that has neither.
PowerMatrix nominal_power(const SpectaclesSpec& spec, const Source& where);

/// Mean power and cylinder of what the lens gives as worn (conoid/tracing/as_worn.h) less `nominal` [D]. Each place is
/// where the line of sight meets the back surface; places outside of the rim or without a power have none.
/// `rotation_center_m` is behind the pupil.
std::vector<LensMap> as_worn_maps(const Spectacles& lens, const PowerMatrix& nominal, double rotation_center_m);

/// What the second lens gives as worn more than the first, at the places of the first through which the same lines of
/// sight go [D]: mean power (red: the second has more) and cylinder of the difference.
std::vector<LensMap> as_worn_difference(const Spectacles& first, const Spectacles& second, double rotation_center_m);

/// What an eye with this correction at its cornea and this amplitude of accommodation [D] has too much behind the lens
/// [D], for targets at `distance_m` (∞ allowed) from the front surface along the chief ray: the vergence that arrives
/// at its pupil minus the vergence that the eye needs there. The eye takes the A in [0, amplitude] that brings the mean
/// of this as near to 0 as possible. The map's value is the mean: positive where the lens has too much power for the
/// target, negative where it has too little, as in as_worn_maps. Its limit value is the larger principal value (the
/// longest diameter of the blur per pupil diameter), drawn at 0.5 D.
LensMap defocus_map(const Spectacles& lens, const PowerMatrix& correction, double rotation_center_m, double distance_m,
                    double amplitude_D);

}  // namespace sturm
