#pragma once
#include "lensmodel/progressive_surface.h"
#include "lensmodel/single_vision.h"
#include "lensmodel/surface_power.h"

namespace sturm {

/// What a progressive lens is made from.
struct ProgressiveDesign {
  SingleVisionDesign lens;  ///< its base curve is the power of the far zone
  double addition_D = 2.0;
  double corridor_start_m = 0.0;       ///< see ProgressiveSurfaceDesign
  double corridor_length_m = 18e-3;    ///< > 0
  double near_shift_m = 0.0;           ///< x of the umbilic at the corridor's lower end, wearer frame
  std::optional<double> zone_width_m;  ///< none: circular sections
  double knot_spacing_m = 0.125e-3;    ///< of the spline that the front is traced as; > 0, at most rim radius / 2
};

struct ProgressiveLens {
  Spectacles lens;              ///< its front is a B-spline surface
  SurfacePower power_residual;  ///< largest differences of mean power and of cylinder between spline and closed form
                                ///< within the rim [D]
  double knot_spacing_m;        ///< as used
};

/// A progressive lens: a progressive front (in closed form, then as a B-spline surface through its heights at the
/// knots) and the back of the single-vision lens of the far prescription `rx`. What a ray meets that stays in the far
/// zone is that single-vision lens if the corridor starts at the fitting cross or below it; if it starts above, the far
/// zone's sphere is the same but leans by what the corridor turned. The residual is sampled at knots and in the middles
/// between them, where the spline's curvature is off most, at most 3 knots apart for usual lenses. Throws what
/// single_vision and ProgressiveSurface throw, and std::domain_error where the front does not reach the rim.
ProgressiveLens progressive_lens(const Prescription& rx, const ProgressiveDesign& design);

/// The front's closed form in such a lens.
ProgressiveSurface progressive_front(const Prescription& rx, const ProgressiveDesign& design);

}  // namespace sturm
