#pragma once
#include <vector>

namespace sturm {

/// A part of the pupil between two circles and two radii.
struct PupilSector {
  double inner, outer;  ///< squares of the circles' radii, in parts of the pupil's: 0 … 1
  double from, to;      ///< turns counter-clockwise, from the wearer's right
};

/// Cuts the pupil into parts of equal area, as compact as they can simply be: sectors, from six parts on about an inner
/// ring of sectors. Throws std::invalid_argument for less than one part.
std::vector<PupilSector> pupil_sectors(int parts);

}  // namespace sturm
