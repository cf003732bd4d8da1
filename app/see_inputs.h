#pragma once
#include <string>
#include <vector>

#include "io/images/depth_map.h"
#include "io/specs/see_spec.h"
#include "wavefront/layers/layered_picture.h"

namespace sturm {

/// The pictures that a document of `sturm see` names.
struct SeeInputs {
  LayeredPicture picture;
  std::vector<PictureLayer> layers;
  double pixel_slope = 0.0;        ///< size of a pixel in tangent units
  long long filled_holes = 0;      ///< of all depth maps
  std::vector<std::string> notes;  ///< for the manifest
};

/// Reads picture, depth and layers. Throws InputError for what is missing, broken, or of another size.
SeeInputs read_see_inputs(const SeeSpec& spec);

}  // namespace sturm
