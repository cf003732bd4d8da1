#pragma once
#include "lensmodel/prescription.h"

namespace sturm {

/// The direction of a line as an examiner writes it down, TABO (0°, 180°], from the wearer frame's: the examiner's x is
/// the wearer's −x (docs/theory.md#1-frames-signs-units).
inline double tabo_deg(double wearer_deg) {
  return folded_axis_deg(180.0 - wearer_deg);
}

}  // namespace sturm
