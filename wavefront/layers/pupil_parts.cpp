#include "wavefront/layers/pupil_parts.h"

#include <stdexcept>

namespace sturm {

std::vector<PupilSector> pupil_sectors(int parts) {
  if (parts < 1) throw std::invalid_argument("a pupil has at least one part");
  const int inner = parts < 6 ? 0 : (parts + 2) / 4;
  const double between = static_cast<double>(inner) / parts;
  std::vector<PupilSector> sectors;
  for (int i = 0; i < inner; ++i)
    sectors.push_back({0.0, between, static_cast<double>(i) / inner, static_cast<double>(i + 1) / inner});
  const int outer = parts - inner;
  for (int i = 0; i < outer; ++i)
    sectors.push_back({between, 1.0, static_cast<double>(i) / outer, static_cast<double>(i + 1) / outer});
  return sectors;
}

}  // namespace sturm
