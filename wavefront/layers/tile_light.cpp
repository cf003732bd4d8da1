#include "wavefront/layers/tile_light.h"

#include <algorithm>

namespace sturm {

void TileLight::clear() {
  for (Image& plane : planes) std::fill(plane.pixels.begin(), plane.pixels.end(), 0.0f);
}

}  // namespace sturm
