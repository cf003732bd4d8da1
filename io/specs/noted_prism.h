#pragma once
#include "io/specs/prescription_notation.h"

namespace sturm {

/// A prism and its base, counter-clockwise as an examiner faces the wearer.
struct Prism {
  double cm_per_m;  ///< ≥ 0
  double base_deg;  ///< 0 ≤ base < 360
};

/// All prism of a text as one; its eye must be known where it has a base in or out.
Prism prism_of(const NotedPrescription& rx);

}  // namespace sturm
