#pragma once
#include <vector>

#include "io/json/json.h"
#include "io/specs/spectacles_spec.h"

namespace sturm {

/// A lens and the gazes to look through it: all pairs of azimuth (to the wearer's right) and elevation (up), |angle| ≤
/// 89°.
struct LensQuery {
  Spectacles lens;                                    ///< whose powers are asked for
  std::optional<LensMaterial> material;               ///< if known: for its dispersion
  std::vector<FreeFormFit> fits;                      ///< to be reported
  double rotation_center_m = mean_rotation_center_m;  ///< behind the pupil
  std::vector<double> azimuths_deg, elevations_deg;   ///< [°], wearer frame
};

/// A sturm.lens_report/1 document; its gazes run through the azimuths first.
Json lens_report(const LensQuery& query);

}  // namespace sturm
