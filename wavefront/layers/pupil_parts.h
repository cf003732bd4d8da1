#pragma once
#include <vector>

#include "wavefront/psf/pupil_sector.h"

namespace sturm {

/// Cuts the pupil into parts of equal area, as compact as they can simply be: sectors, from six parts on about an inner
/// ring of sectors. Throws std::invalid_argument for less than one part.
std::vector<PupilSector> pupil_sectors(int parts);

}  // namespace sturm
