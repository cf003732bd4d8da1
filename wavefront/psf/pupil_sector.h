#pragma once

namespace sturm {

/// A part of the pupil between two circles and two radii; the whole pupil if nothing else is said.
struct PupilSector {
  double inner = 0.0, outer = 1.0;  ///< squares of the circles' radii, in parts of the pupil's: 0 … 1
  double from = 0.0, to = 1.0;      ///< turns counter-clockwise, from the wearer's right
};

}  // namespace sturm
