#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/commands.h"
#include "io/images/depth_map.h"
#include "io/json/json.h"
#include "wavefront/layers/layered_picture.h"

namespace sturm {

/// The pictures that `sturm see` was given.
struct SeeInputs {
  LayeredPicture picture;
  std::vector<PictureLayer> layers;
  double pixel_slope = 0.0;        ///< size of a pixel in tangent units
  long long filled_holes = 0;      ///< of all depth maps
  std::vector<std::string> files;  ///< all that were read
  std::vector<std::string> notes;  ///< for the manifest
};

/// Reads picture, depth and layers. Throws InputError for what is missing, broken, or of another size.
SeeInputs read_see_inputs(const SeeOptions& options);

}  // namespace sturm
