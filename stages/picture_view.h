#pragma once
#include <optional>
#include <string>

#include "compare/images/regions.h"
#include "io/images/image.h"

namespace sturm {

/// What a picture's own metadata tells about how it was seen.
struct PictureView {
  std::optional<double> pixels_per_degree;  ///< at the middle of the picture
  std::optional<double> pixel_slope;        ///< width of a pixel as a slope; perspective only
  RegionLayers layers;                      ///< depth, and blur where it follows from the eye
  std::string missing_blur;                 ///< why there is no layer of blur; "" where there is one
};

/// Reads the text attribute `sturm` (the resolved sturm.render/1) and the layer `depth` of a rendered picture; whatever
/// is not there stays none. Blur needs a naked eye in perspective and `camera` gaze, for which one formula holds over
/// the whole picture.
PictureView view_of(const LayeredImage& picture);

/// The first of two pictures that knows each thing.
PictureView view_of(const LayeredImage& first, const LayeredImage& second);

}  // namespace sturm
