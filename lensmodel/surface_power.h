#pragma once
#include "lensmodel/sag.h"

namespace sturm {

/// What a surface's bend at one point amounts to, as makers of lenses state it [D]: (n − 1) times the principal
/// curvatures of the surface itself (not of its projection), positive where the centre of curvature lies on the eye's
/// side.
struct SurfacePower {
  double mean_D;      ///< half their sum
  double cylinder_D;  ///< size of their difference, ≥ 0
};

SurfacePower surface_power(const Sag& sag, double refractive_index);  ///< at the point of `sag`; n ≥ 1

}  // namespace sturm
