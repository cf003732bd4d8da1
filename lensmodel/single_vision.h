#pragma once
#include <optional>

#include "lensmodel/prescription.h"
#include "lensmodel/spectacles.h"

namespace sturm {

/// What a single-vision lens is made from.
struct SingleVisionDesign {
  std::optional<double> base_curve_D;  ///< power of the front surface, a sphere, in the lens's own index [D]; 0 =
                                       ///< plane; none: usual_base_curve_D
  double center_thickness_m = 2e-3;
  double refractive_index = 1.5;
  double vertex_distance_m = Spectacles{}.vertex_distance_m;
  double diameter_m = Spectacles{}.diameter_m;
  Mounting mounting{};
};

/// The front that single-vision lenses of this power usually have [D]: Vogel's rule, M + 6 for M ≥ 0 and M/2 + 6 for M
/// < 0, never hollow (M the spherical equivalent). It approximates the flatter forms without oblique astigmatism for
/// the distance (Tscherning's ellipse, Ostwalt's branch), between −10 and +6 D within 1.45 D.
double usual_base_curve_D(const Prescription& rx);

/// A lens with a spherical front and a spherical or toric back whose back vertex power is the prescription as written
/// (its vertex distance is not used). The back is swept along the AXIS of the minus-cylinder form, so both ways of
/// writing make the same lens. A prism turns the back surface (lensmodel/prism.h): the powers are those along its own
/// axis then. Throws std::invalid_argument for an index of 1, which has no power, and std::domain_error where the front
/// surface's focus lies in the back vertex.
Spectacles single_vision(const Prescription& rx, const SingleVisionDesign& design);

/// Power of a lens at its back vertex along its principal meridians [D], first order: F₂ + F₁/(1 − (t/n) F₁).
double back_vertex_power(double front_power_D, double back_power_D, double thickness_m, double refractive_index);

}  // namespace sturm
