#pragma once

namespace sturm {

/// A spectacle prescription as it is written: SPH / CYL × AXIS, stated for a lens at a vertex distance before the
/// cornea. docs/theory.md#1-frames-signs-units and docs/theory.md#2-from-a-prescription-to-a-power-matrix. Plus- and
/// minus-cylinder forms are both accepted and mean the same lens when transposed into each other.
struct Prescription {
  double sphere_D = 0.0;    ///< sphere [D]; power along the AXIS meridian
  double cylinder_D = 0.0;  ///< cylinder [D], either sign; acts across the AXIS
  double axis_deg = 180.0;  ///< TABO (ISO 8429) [°], counter-clockwise as an examiner faces the wearer; 0 means 180
  double vertex_distance_m = 0.0;  ///< distance from lens to cornea [m]; 0 = stated at the cornea
  double prism_cm_per_m = 0.0;     ///< prism [Δ], ≥ 0; without effect on the power
  double prism_base_deg = 0.0;     ///< its base, 0 ≤ base < 360, counter-clockwise as an examiner faces the wearer

  double spherical_equivalent_D() const { return sphere_D + 0.5 * cylinder_D; }  ///< S + C/2 [D]
};

/// The same lens with the opposite sign of cylinder: (S + C, −C, AXIS ± 90), AXIS in (0, 180].
Prescription transposed(const Prescription& rx);

/// The same lens with a cylinder ≤ 0 and AXIS in (0, 180]; AXIS 180 where there is no cylinder.
Prescription in_minus_cylinder_form(const Prescription& rx);

/// Folds an AXIS into the notation's range (0, 180].
double folded_axis_deg(double axis_deg);

/// Throws std::invalid_argument unless every number is finite, |sphere| and |cylinder| are at most 40 D,
/// 0 ≤ AXIS ≤ 180, 0 ≤ vertex distance ≤ 50 mm, 0 ≤ prism ≤ 40 Δ and 0 ≤ base ≤ 360.
void validate(const Prescription& rx);

}  // namespace sturm
